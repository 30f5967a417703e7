// SPDX-License-Identifier: BSD-3-Clause
// Has an object just learned really left its place in the scene after?
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// [0..1] Part of the map's changed pixels that looked like the platform around the map before and
/// no longer do. Near 0 when the object has left; about a half when it was put down again so near
/// that its old place and the new one were taken for one object. Pictures are CV_8UC3 of one size.
double part_put_down(const cv::Mat& map, const cv::Mat& before, const cv::Mat& after);

/// From here on of part_put_down() the map holds more than the object.
constexpr double kMostPutDown = 0.25;

}  // namespace mbncc
