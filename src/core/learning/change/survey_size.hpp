// SPDX-License-Identifier: BSD-3-Clause
// The image size at which whole images are surveyed for change.
#pragma once

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc::change {

constexpr int kSurveyWidth = 320;  ///< [px]

/// Scale factor from an image of `width` [px] to the size of the survey, at most 1.
inline double survey_scale(int width) {
  return std::min(1.0, static_cast<double>(kSurveyWidth) / width);
}

/// `image` scaled to the size of the survey.
inline cv::Mat survey_sized(const cv::Mat& image) {
  const double scale = survey_scale(image.cols);
  cv::Mat small;
  cv::resize(image, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

}  // namespace mbncc::change
