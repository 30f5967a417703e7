// SPDX-License-Identifier: BSD-3-Clause
// Equivalent poses of symmetric objects in a region.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/geometry.hpp"

namespace mbncc::decision {

/// Whether a pixel of `region` contains `point`, or it is empty. [px]
bool contains(const cv::Rect& region, cv::Point2d point);

/// `pose`, or if it does not lie in `region` [px], an equivalent pose that does, turned about
/// `centre` by a part of the `symmetry` (1: none, 2: half turns ..., 0: round); `pose` itself if
/// there is none. Of a round object, the one that is the nearest to the middle of the region is
/// tried.
Pose2D equivalent_within(const cv::Rect& region, const Pose2D& pose, int symmetry,
                         cv::Point2d centre);

}  // namespace mbncc::decision
