// What a comparison at a pose says about the small motion that is left.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Of a template's frame: shift along x and y [px at level], turn [rad], stretch [1].
using Motion = cv::Vec4d;
constexpr int kMotionParts = 4;

/// Normal equations of a motion, in units of its information: information * motion = vector.
struct MotionPull {
  cv::Matx44d information;
  Motion vector;

  MotionPull& operator+=(const MotionPull& other);
};

/// The same where what is compared may itself be shifted by an unknown amount of this `deviation`
/// [px] along x and y.
MotionPull loosened(const MotionPull& pull, double deviation);

/// The same where it may also be turned and stretched, by as much at `radius` [px].
MotionPull loosened_throughout(const MotionPull& pull, double deviation, double radius);

}  // namespace mbncc
