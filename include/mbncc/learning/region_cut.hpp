// SPDX-License-Identifier: BSD-3-Clause
// Region cut: as the change cut, but from one image, whose platform is predicted from the
// surroundings of the region.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/learning/object_cut.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc {

/// Cuts the object out of one image: the platform under it is predicted from the ring around
/// `region`.
ObjectCut region_cut(const cv::Mat& before, const cv::Rect& region, int iterations,
                     const BeforeCut& before_cut = {});

}  // namespace mbncc
