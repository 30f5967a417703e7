// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/images.hpp"

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc::console {
namespace {

namespace encodings = sensor_msgs::image_encodings;

constexpr int kFullRange = 65535;  // maximum of 16 bits
constexpr int kSquare = 8;         // [px] of the checkerboard
constexpr int kShownWidth = 1600;  // [px]
constexpr int kSampled = 8;        // [px] between the samples for the change of light
constexpr double kChanged = 24;    // [grey levels] in any channel, after smoothing
const cv::Scalar kTint(230, 159, 0);

cv::Mat checkerboard(cv::Size size) {
  cv::Mat board(size, CV_8UC3);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      board.at<cv::Vec3b>(y, x) = cv::Vec3b::all((x / kSquare + y / kSquare) % 2 == 0 ? 235 : 190);
  return board;
}

cv::Mat smoothed(const cv::Mat& image) {
  cv::Mat result;
  cv::blur(image, result, {5, 5});
  return result;
}

/// `image` with the brightness and colour of `first`: each channel is scaled by the median ratio.
cv::Mat in_light_of(const cv::Mat& first, const cv::Mat& image) {
  cv::Scalar factors;
  for (int channel = 0; channel < 3; ++channel) {
    std::vector<double> ratios;
    for (int y = 0; y < image.rows; y += kSampled)
      for (int x = 0; x < image.cols; x += kSampled)
        ratios.push_back((first.at<cv::Vec3b>(y, x)[channel] + 1.0) /
                         (image.at<cv::Vec3b>(y, x)[channel] + 1.0));
    const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
    std::nth_element(ratios.begin(), middle, ratios.end());
    factors[channel] = *middle;
  }
  cv::Mat lit;
  cv::multiply(image, factors, lit);
  return lit;
}

/// Converts 16-bit images. 16UC1 does not define its white level, so it needs `white_level`.
cv::Mat deep_to_rgb(const sensor_msgs::Image& message, int white_level) {
  if (message.encoding == encodings::TYPE_16UC1) {
    if (white_level == 0) return {};
    sensor_msgs::Image named = message;
    named.encoding = encodings::MONO16;
    return deep_to_rgb(named, white_level);
  }
  cv::Mat image;
  const double white = white_level == 0 ? kFullRange : white_level;
  cv_bridge::toCvCopy(message, encodings::RGB16)->image.convertTo(image, CV_8U, 255 / white);
  return image;
}

}  // namespace

cv::Mat to_rgb(const sensor_msgs::Image& message, int white_level) {
  if (message.width == 0 || message.height == 0) return {};
  try {
    const bool deep = encodings::bitDepth(message.encoding) == 16;
    return deep ? deep_to_rgb(message, white_level) : cv_bridge::toCvCopy(message, "rgb8")->image;
  } catch (const std::exception&) {
    return {};
  }
}

cv::Mat small(const cv::Mat& image) {
  if (image.cols <= kShownWidth) return image;
  cv::Mat shrunk;
  const double factor = static_cast<double>(kShownWidth) / image.cols;
  cv::resize(image, shrunk, {}, factor, factor, cv::INTER_AREA);
  return shrunk;
}

cv::Mat on_checkerboard(const cv::Mat& template_image, const sensor_msgs::Image& map) {
  if (template_image.empty() || map.data.size() < std::size_t{map.step} * map.height) return {};
  const cv::Mat mask(static_cast<int>(map.height), static_cast<int>(map.width), CV_8UC1,
                     const_cast<std::uint8_t*>(map.data.data()), map.step);
  if (mask.size() != template_image.size()) return {};
  cv::Mat shown = checkerboard(template_image.size());
  template_image.copyTo(shown, mask);
  return shown;
}

cv::Mat ChangeTint::tint(const cv::Mat& image) {
  const cv::Mat now = smoothed(image);
  if (first_.size() != now.size()) {
    first_ = now;
    return image;
  }
  cv::Mat difference;
  cv::absdiff(in_light_of(first_, now), first_, difference);
  cv::Mat channels[3];
  cv::split(difference, channels);
  const cv::Mat changed = cv::max(channels[0], cv::max(channels[1], channels[2])) > kChanged;
  cv::Mat tinted = image.clone(), half;
  cv::addWeighted(image, 0.5, cv::Mat(image.size(), CV_8UC3, kTint), 0.5, 0, half);
  half.copyTo(tinted, changed);
  return tinted;
}

}  // namespace mbncc::console
