// SPDX-License-Identifier: BSD-3-Clause
// Number of kills in tests.
#pragma once

#include <cstdlib>

namespace mbncc::test {

/// `usual`, or the value of MBNCC_KILLS.
inline int kills_wanted(int usual) {
  const char* wanted = std::getenv("MBNCC_KILLS");
  return wanted == nullptr ? usual : std::atoi(wanted);
}

}  // namespace mbncc::test
