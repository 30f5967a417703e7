// SPDX-License-Identifier: BSD-3-Clause
// What a comparison at a pose says about the small motion that is left.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Of a template's frame: shift along x and y [px at level], turn [rad], stretch [1].
using Motion = cv::Vec4d;
constexpr int kMotionParts = 4;

/// Normal equations of a motion, in units of its information: information * motion = vector.
struct NormalEquations {
  cv::Matx44d information;
  Motion vector;

  NormalEquations& operator+=(const NormalEquations& other);
};

/// The same where what is compared may itself be shifted by an unknown amount of this `deviation`
/// [px] along x and y.
NormalEquations loosened(const NormalEquations& pull, double deviation);

/// The same where it may also be turned and stretched, by as much at `radius` [px].
NormalEquations loosened_throughout(const NormalEquations& pull, double deviation, double radius);

}  // namespace mbncc
