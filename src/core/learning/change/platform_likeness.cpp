// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/platform_likeness.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/change/colour_mixture.hpp"

namespace mbncc::change {
namespace {

constexpr double kSmoothing = 1;  // [px] standard deviation
constexpr double kRare = 0.05;    // part of the platform's own pixels that counts as rare

cv::Mat smoothed(const cv::Mat& image, const cv::Rect& box) {
  cv::Mat values;
  image(box).convertTo(values, CV_32F);
  cv::GaussianBlur(values, values, {}, kSmoothing);
  return values;
}

// Density that all but the rarest pixels (kRare) on the map reach.
float usual_density(const cv::Mat& densities, const cv::Mat& map) {
  std::vector<float> values;
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x)
      if (map.at<uchar>(y, x)) values.push_back(densities.at<float>(y, x));
  const auto rare = values.begin() + static_cast<std::ptrdiff_t>(kRare * values.size());
  std::nth_element(values.begin(), rare, values.end());
  return *rare;
}

}  // namespace

double platform_likeness(const cv::Mat& before, const cv::Mat& after, const cv::Mat& map) {
  const cv::Rect box = cv::boundingRect(map);
  const cv::Mat object = map(box), now = smoothed(after, box);
  const ColourMixture platform = ColourMixture::fit(now, object);
  if (platform.empty()) return 0;
  const float usual = usual_density(platform.densities(now), object);
  const cv::Mat alike = platform.densities(smoothed(before, box)) >= usual;
  return cv::countNonZero(alike & object) / static_cast<double>(cv::countNonZero(object));
}

}  // namespace mbncc::change
