// SPDX-License-Identifier: BSD-3-Clause
// Images of a simulated platform with plain objects on it.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "learning/images.hpp"

namespace mbncc::test {

const cv::Size kPlatformSize(160, 120);  // [px]

/// CV_32FC3 image of the platform with plain objects at `places`.
inline cv::Mat image_with(const std::vector<cv::Rect>& places, int seed) {
  cv::Mat radiance = texture(kPlatformSize, cv::Scalar(105, 115, 120), 8, 1), values;
  for (const auto& place : places) radiance(place).setTo(cv::Scalar(40, 60, 190));
  exposed(radiance, seed).convertTo(values, CV_32F);
  return values;
}

inline cv::Mat map_of(const std::vector<cv::Rect>& places) {
  cv::Mat map = cv::Mat::zeros(kPlatformSize, CV_8UC1);
  for (const auto& place : places) map(place).setTo(255);
  return map;
}

}  // namespace mbncc::test
