// SPDX-License-Identifier: BSD-3-Clause
// How often tests kill what they watch.
#pragma once

#include <cstdlib>

namespace mbncc::test {

/// `usual`, or what MBNCC_KILLS asks for.
inline int kills_wanted(int usual) {
  const char* wanted = std::getenv("MBNCC_KILLS");
  return wanted == nullptr ? usual : std::atoi(wanted);
}

}  // namespace mbncc::test
