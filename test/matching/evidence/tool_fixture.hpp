// SPDX-License-Identifier: BSD-3-Clause
// A drawn tool whose handle has a colour of its own.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <opencv2/imgproc.hpp>

#include "mbncc/object_model.hpp"

namespace mbncc::test {

const cv::Scalar kSteel(150, 150, 150), kRed(40, 40, 170), kBlack(30, 30, 30),
    kTable(225, 225, 230);

/// A tool on a white table: steel with a handle.
class ToolTest : public ::testing::Test {
 protected:
  static constexpr int kHandle = 60, kLength = 150, kWidth = 24;
  const cv::Rect tool_{75, 60, kLength, kWidth};

  static void add_noise(cv::Mat& image, std::uint64_t seed) {
    cv::Mat noise(image.size(), CV_16SC3), sum;
    cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, 3);
    image.convertTo(sum, CV_16S);
    sum += noise;
    sum.convertTo(image, CV_8U);
  }

  /// The head is marked, so that the tool looks different after a half turn.
  cv::Mat image_with(const cv::Scalar& handle, std::uint64_t seed) const {
    cv::Mat image(150, 300, CV_8UC3, kTable);
    image(tool_) = kSteel;
    image(cv::Rect(tool_.tl(), cv::Size(kHandle, kWidth))) = handle;
    cv::circle(image, {tool_.br().x - 14, tool_.y + kWidth / 2}, 6, kBlack, cv::FILLED);
    add_noise(image, seed);
    return image;
  }

  static std::shared_ptr<ObjectModel> object_of(const cv::Mat& image, const cv::Mat& map) {
    auto model = std::make_shared<ObjectModel>();
    model->name = "tool";
    model->views.push_back(crop_view(image, map, {150, 72, 0}));
    return model;
  }

  std::shared_ptr<ObjectModel> tool() const {
    cv::Mat map = cv::Mat::zeros(150, 300, CV_8UC1);
    map(tool_) = 255;
    return object_of(image_with(kRed, 1), map);
  }
};

}  // namespace mbncc::test
