// SPDX-License-Identifier: BSD-3-Clause
// CPU time of this thread, which hardly depends on other programs on the machine.
#pragma once

#include <ctime>

namespace mbncc::bench {

inline double thread_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Thread CPU time of one call. [ms]
template <class Call>
double cpu_ms_of(const Call& call) {
  const double start = thread_cpu_ms();
  call();
  return thread_cpu_ms() - start;
}

}  // namespace mbncc::bench
