// SPDX-License-Identifier: BSD-3-Clause
// The result of change_cut() or region_cut().
#pragma once

#include <functional>
#include <opencv2/core.hpp>

#include "mbncc/learning/cut_evidence.hpp"

namespace mbncc {

struct ObjectCut {
  cv::Mat map;  ///< CV_8UC1 of the images' size, 0/255; all 0 when nothing in the region changed
  CutEvidence evidence;
  /// Log-odds of object against platform used for the cut: CV_32FC1 of the images' size, within
  /// +-8, -8 outside the region. Empty if nothing changed.
  std::function<cv::Mat()> preference;

  // Continues from this result with one more cut. The operator's strokes are hard constraints
  // (CV_8UC1 of the images' size, 255 on a stroke). Empty if nothing changed.
  std::function<ObjectCut(const cv::Mat& include, const cv::Mat& exclude)> cut_again;
  /// Continues from this result with one more cut, which adds another view's `preference`, warped
  /// onto this view. Empty if nothing changed.
  std::function<ObjectCut(const cv::Mat& preference)> cut_with;
};

}  // namespace mbncc
