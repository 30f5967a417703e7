// SPDX-License-Identifier: BSD-3-Clause
// Normal equations of a small motion at a pose.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::numeric {

/// Motion of a template's frame: shift along x and y [px at level], rotation [rad], scale change
/// [1].
using Motion = cv::Vec4d;
constexpr int kMotionParts = 4;

/// Normal equations of a motion: information * motion = vector.
struct NormalEquations {
  cv::Matx44d information;
  Motion vector;

  NormalEquations& operator+=(const NormalEquations& other);
};

/// The equations, marginalised over an unknown shift of this `deviation` [px] along x and y.
NormalEquations marginalised_over_shift(const NormalEquations& pull, double deviation);

/// The equations, also marginalised over a rotation and a scaling that move points at `radius` [px]
/// by as much.
NormalEquations marginalised_over_shift_and_turn(const NormalEquations& pull, double deviation,
                                                 double radius);

}  // namespace mbncc::numeric
