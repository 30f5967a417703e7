// SPDX-License-Identifier: BSD-3-Clause
#include "console/calibration/image_check.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::console {
namespace {

constexpr int kBurnt = 250;          // [grey levels] overexposed from here on
constexpr double kMostBurnt = 0.01;  // [0..1] fraction of the pixels
constexpr double kDark = 0.15;       // [0..1] mean brightness
constexpr double kSharp = 0.9;       // fraction of the best sharpness

}  // namespace

void ImageCheck::take(const cv::Mat& image) {
  cv::Mat grey, edges;
  cv::cvtColor(image, grey, cv::COLOR_RGB2GRAY);
  cv::Laplacian(grey, edges, CV_32F);
  cv::Scalar mean, deviation, edge_mean, edge_deviation;
  cv::meanStdDev(grey, mean, deviation);
  cv::meanStdDev(edges, edge_mean, edge_deviation);
  // Normalised by the contrast, so that the exposure has no effect.
  now_ = edge_deviation[0] / (deviation[0] + 1);
  best_ = std::max(best_, now_);
  brightness_ = mean[0] / 255;
  burnt_ = cv::countNonZero(grey >= kBurnt) / static_cast<double>(grey.total());
}

std::string ImageCheck::advice() const {
  const std::string part = std::to_string(std::lround(100 * sharpness()));
  const std::string focus =
      sharpness() >= kSharp
          ? "Sharpness: " + part +
                " % of the sharpest so far; turn the focus ring through its maximum once."
          : "Sharpness: " + part + " % of the sharpest: turn the focus ring back.";
  const std::string light =
      burnt_ > kMostBurnt ? " Too bright: " + std::to_string(std::lround(100 * burnt_)) +
                                " % is overexposed; reduce the exposure time."
      : brightness_ < kDark ? " Too dark: increase the exposure time or add light."
                            : " The exposure is right.";
  return focus + light;
}

}  // namespace mbncc::console
