// SPDX-License-Identifier: BSD-3-Clause
#include "base/number.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace mbncc {

std::string number(double value, int digits) {
  const double step = std::pow(10.0, -digits);
  std::ostringstream text;
  text << std::fixed << std::setprecision(digits) << (std::abs(value) < step / 2 ? 0 : value);
  return text.str();
}

}  // namespace mbncc
