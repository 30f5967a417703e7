// SPDX-License-Identifier: BSD-3-Clause
#include "console/notice.hpp"

namespace mbncc::console {

void Notice::post(const Line& line, double now) {
  line_ = line;
  until_ = now + kStays;
}

const Notice::Line& Notice::over(const Line& lesson, double now) const {
  return now < until_ ? line_ : lesson;
}

}  // namespace mbncc::console
