// SPDX-License-Identifier: BSD-3-Clause
// Change cut: a graph cut that separates the object from the platform in the image before. The
// likelihood of the platform is computed from the image after, allowing for shadows; the cut
// follows edges that disappeared with the object.
#pragma once

#include <functional>
#include <opencv2/core.hpp>

#include "mbncc/learning/cut_evidence.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc {

struct ChangeCut {
  cv::Mat map;  ///< CV_8UC1 of the images' size, 0/255; all 0 when nothing in the region changed
  CutEvidence evidence;
  /// Log-odds of object against platform used for the cut: CV_32FC1 of the images' size, within
  /// +-8, -8 outside the region. Empty if nothing changed.
  std::function<cv::Mat()> preference;

  // Continues from this result with one more cut. The operator's strokes are hard constraints
  // (CV_8UC1 of the images' size, 255 on a stroke). Empty if nothing changed.
  std::function<ChangeCut(const cv::Mat& include, const cv::Mat& exclude)> cut_again;
  /// Continues from this result with one more cut, which adds another view's `preference`, warped
  /// onto this view. Empty if nothing changed.
  std::function<ChangeCut(const cv::Mat& preference)> cut_with;
};

/// `before` and `after` are CV_8UC3 of one size; `region` contains the object and lies inside the
/// images. `changed` (CV_8UC1, from survey_change()) marks all changes coarsely. The camera may
/// have moved by up to `max_shift` pixels.
ChangeCut change_cut(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                     const cv::Mat& changed, int iterations, int max_shift,
                     const BeforeCut& before_cut = {});

/// Cuts the object out of one image: the platform under it is predicted from the ring around
/// `region`.
ChangeCut region_cut(const cv::Mat& before, const cv::Rect& region, int iterations,
                     const BeforeCut& before_cut = {});

}  // namespace mbncc
