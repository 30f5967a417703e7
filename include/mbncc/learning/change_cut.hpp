// SPDX-License-Identifier: BSD-3-Clause
// Change cut: a graph cut that separates the object from the platform in the image before. The
// likelihood of the platform is computed from the image after, allowing for shadows; the cut
// follows edges that disappeared with the object.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/learning/object_cut.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc {

/// `before` and `after` are CV_8UC3 of one size; `region` contains the object and lies inside the
/// images. `changed` (CV_8UC1, from survey_change()) marks all changes coarsely. The camera may
/// have moved by up to `max_shift` pixels.
ObjectCut change_cut(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                     const cv::Mat& changed, int iterations, int max_shift,
                     const BeforeCut& before_cut = {});

}  // namespace mbncc
