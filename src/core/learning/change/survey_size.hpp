// SPDX-License-Identifier: BSD-3-Clause
// The size for the survey of whole images.
#pragma once

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc::change {

constexpr int kSurveyWidth = 320;  ///< [px]

/// From an image of this width [px] to the survey's, which is never larger.
inline double survey_scale(int width) {
  return std::min(1.0, static_cast<double>(kSurveyWidth) / width);
}

/// `image` at the survey's size.
inline cv::Mat survey_sized(const cv::Mat& image) {
  const double scale = survey_scale(image.cols);
  cv::Mat small;
  cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

}  // namespace mbncc::change
