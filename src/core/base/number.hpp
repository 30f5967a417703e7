// SPDX-License-Identifier: BSD-3-Clause
// Numbers in messages.
#pragma once

#include <string>

namespace mbncc {

/// `value` with that many decimals; without a sign if it is rounded to zero.
std::string number(double value, int digits);

}  // namespace mbncc
