// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/departures.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "learning/change/departure_scores.hpp"
#include "learning/change/survey_size.hpp"

namespace mbncc::change {
namespace {

constexpr double kLoneArrivalScore = -0.5;  // score below which a patch is an arrival

cv::Mat surveyed(const cv::Mat& image) {
  cv::Mat values;
  survey_sized(image).convertTo(values, CV_32F);
  return values;
}

// `after` with the exposure of `before`, from their means over the unchanged pixels.
cv::Mat exposed_as(const cv::Mat& before, const cv::Mat& after, const cv::Mat& unchanged) {
  const cv::Scalar wanted = cv::mean(before, unchanged), given = cv::mean(after, unchanged);
  cv::Mat channels[3], result;
  cv::split(after, channels);
  for (int c = 0; c < 3; ++c) channels[c] *= wanted[c] / std::max(1.0, given[c]);
  cv::merge(channels, 3, result);
  return result;
}

}  // namespace

cv::Mat departures(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed) {
  const cv::Mat b = surveyed(before), a = surveyed(after);
  cv::Mat patches, near, labels, left = cv::Mat::zeros(b.size(), CV_32FC1), result;
  cv::resize(changed, patches, b.size(), 0, 0, cv::INTER_NEAREST);
  cv::dilate(patches, near, cv::Mat(), {-1, -1}, 3);
  const cv::Mat unchanged = near == 0;
  const ColourMixture platform = ColourMixture::fit(b, unchanged);
  if (platform.empty()) return cv::Mat_<float>(changed / 255);
  const int count = cv::connectedComponents(patches, labels, 8, CV_32S);
  const auto scores = departure_scores(b, exposed_as(b, a, unchanged), labels, count, platform);
  for (int i = 1; i < count; ++i)
    left.setTo(std::max(0.0, scores[i] - kLoneArrivalScore), labels == i);
  cv::resize(left, result, changed.size(), 0, 0, cv::INTER_NEAREST);
  return result;
}

}  // namespace mbncc::change
