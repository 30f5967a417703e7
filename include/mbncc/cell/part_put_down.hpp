// SPDX-License-Identifier: BSD-3-Clause
// Checks that an object just learned has left its place in the scene after.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// [0..1] Part of the map's changed pixels that looked like the platform around the map before and
/// no longer do. Near 0 if the object has left; about 0.5 if it was put down so near that its old
/// and new place were segmented as one object. Images are CV_8UC3 of one size.
double part_put_down(const cv::Mat& map, const cv::Mat& before, const cv::Mat& after);

/// If part_put_down() is at least this, and CutEvidence::edges_after at least kMostEdgesAfter, the
/// map contains more than the object.
constexpr double kMostPutDown = 0.25, kMostEdgesAfter = 0.15;

}  // namespace mbncc
