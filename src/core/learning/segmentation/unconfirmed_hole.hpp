// SPDX-License-Identifier: BSD-3-Clause
// Holes of a map that may belong to the object.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::segmentation {

/// Area of the holes of `map` (CV_8UC1) that may be parts of the object, relative to the map with
/// these holes filled [0..1]. A part with the platform's colour changes no more than the platform
/// does in a shadow. A hole is confirmed if its pixels in `before` and `after` (CV_32FC3, aligned)
/// have the same colour, or show the same texture, or if `excluded` (CV_8UC1, or empty) marks a
/// pixel of it, its rim of 3 px excepted. Holes with less than 30 such pixels do not count.
double unconfirmed_hole(const cv::Mat& map, const cv::Mat& before, const cv::Mat& after,
                        const cv::Mat& excluded);

/// Part [0..1] of the map, its holes filled, that is hole, without holes of which `excluded` covers
/// an inner pixel. `map`, `excluded`: as above.
double enclosed_part(const cv::Mat& map, const cv::Mat& excluded);

}  // namespace mbncc::segmentation
