// SPDX-License-Identifier: BSD-3-Clause
// The size for the survey of whole pictures.
#pragma once

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc::change {

constexpr int kSurveyWidth = 320;  ///< [px]

/// From a picture of this width [px] to the survey's, which is never larger.
inline double survey_scale(int width) {
  return std::min(1.0, static_cast<double>(kSurveyWidth) / width);
}

/// `picture` at the survey's size.
inline cv::Mat survey_sized(const cv::Mat& picture) {
  const double scale = survey_scale(picture.cols);
  cv::Mat small;
  cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

}  // namespace mbncc::change
