// SPDX-License-Identifier: BSD-3-Clause
// Time that this thread has computed: what other programs on the machine do hardly shows.
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
