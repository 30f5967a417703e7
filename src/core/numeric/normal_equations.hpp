// SPDX-License-Identifier: BSD-3-Clause
// Normal equations of a small motion at a pose.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::numeric {

/// Of a template's frame: shift along x and y [px at level], turn [rad], stretch [1].
using Motion = cv::Vec4d;
constexpr int kMotionParts = 4;

/// Normal equations of a motion, in units of its information: information * motion = vector.
struct NormalEquations {
  cv::Matx44d information;
  Motion vector;

  NormalEquations& operator+=(const NormalEquations& other);
};

/// The same, marginalised over an unknown shift of this `deviation` [px] along x and y.
NormalEquations marginalised_over_shift(const NormalEquations& pull, double deviation);

/// The same, also marginalised over a rotation and a stretch by as much at `radius` [px].
NormalEquations marginalised_over_shift_and_turn(const NormalEquations& pull, double deviation,
                                                 double radius);

}  // namespace mbncc::numeric
