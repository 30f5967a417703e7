// SPDX-License-Identifier: BSD-3-Clause
// Rotations at which one of an object's views is searched; the other views cover the rest.
#pragma once

#include "mbncc/geometry.hpp"

namespace mbncc::proposal {

struct AngleRange {
  double low = -2 * kPi, high = 2 * kPi;  ///< [rad] about 0; all by default

  bool contains(double angle) const {
    const double wrapped = wrap_angle(angle);
    return wrapped >= low && wrapped <= high;
  }
};

}  // namespace mbncc::proposal
