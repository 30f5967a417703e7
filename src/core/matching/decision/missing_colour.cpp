// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/missing_colour.hpp"

#include <opencv2/imgproc.hpp>

#include "imaging/filled_outline.hpp"
#include "matching/decision/conclusion.hpp"

namespace mbncc::decision {
namespace {

constexpr double kColourless = 6;  // [grey levels]

/// Mean difference [grey levels] of the channels within `outline` [px]. Noise is averaged first.
double chroma_within(const std::vector<cv::Point2f>& outline, const cv::Mat& image) {
  constexpr int kSmoothing = 5;  // [px]
  const cv::Rect box = cv::boundingRect(outline) & cv::Rect({0, 0}, image.size());
  if (box.empty()) return 0;
  cv::Mat colours;
  cv::blur(image(box), colours, {kSmoothing, kSmoothing});
  std::vector<cv::Mat> channels;
  cv::split(colours, channels);
  const cv::Mat largest = cv::max(cv::max(channels[0], channels[1]), channels[2]);
  const cv::Mat smallest = cv::min(cv::min(channels[0], channels[1]), channels[2]);
  return cv::mean(largest - smallest, imaging::filled(outline, box))[0];
}

}  // namespace

void doubt_missing_colour(const std::function<bool(const std::string& name)>& is_taught_in_colour,
                          const cv::Mat& image, bool grey, const SearchConfig& config,
                          std::vector<Match>& matches) {
  for (auto& match : matches) {
    if (is_taught_in_colour(match.name) != grey) continue;
    if (!grey && chroma_within(match.outline, image) <= kColourless) continue;
    match.doubts.push_back(
        {false, grey ? "the image is grey, so colours cannot be compared; teach it in grey"
                     : "taught in grey, so colours cannot be compared; teach it in colour"});
    conclude(match, config);
  }
}

}  // namespace mbncc::decision
