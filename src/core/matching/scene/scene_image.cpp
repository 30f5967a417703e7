// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_image.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "imaging/pyramid.hpp"

namespace mbncc::scene {
namespace {

void check_type(const cv::Mat& image) {
  if (image.type() != CV_8UC3 && image.type() != CV_8UC1)
    throw std::invalid_argument("an image to search must be 8-bit colour or grey");
}

void check(const cv::Mat& image) {
  constexpr int kSmallest = 16;
  check_type(image);
  if (image.cols < kSmallest || image.rows < kSmallest)
    throw std::invalid_argument("an image to search must have at least 16 x 16 pixels");
}

}  // namespace

cv::Mat grey_image(const cv::Mat& image) {
  check(image);
  if (image.type() == CV_8UC1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

bool is_grey(const cv::Mat& image) {
  check_type(image);
  if (image.type() == CV_8UC1) return true;
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<cv::Vec3b>(y);
    if (std::any_of(row, row + image.cols,
                    [](const cv::Vec3b& p) { return p[0] != p[1] || p[1] != p[2]; }))
      return false;
  }
  return true;
}

SceneImage::SceneImage(const cv::Mat& image, int top_level) {
  show(image, top_level);
}

void SceneImage::show(const cv::Mat& image, int top_level) {
  check(image);
  const bool in_colour = image.type() == CV_8UC3;
  cv::cvtColor(image, converted_, in_colour ? cv::COLOR_BGR2GRAY : cv::COLOR_GRAY2BGR);
  imaging::build_pyramid(in_colour ? converted_ : image, top_level, grey);
  imaging::build_pyramid(in_colour ? image : converted_, top_level, colours_);
  levels.resize(colours_.size());
  padded_.resize(grey.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    levels[level].show(colours_[level], static_cast<int>(level));
    if (!padded_[level]) padded_[level] = std::make_unique<PaddedCache<imaging::PaddedImage>>();
    padded_[level]->forget();
  }
  classes_.reset();
}

const imaging::ClassImages& SceneImage::classes() const {
  const std::lock_guard<std::mutex> lock(sorting_);
  if (!classes_) classes_.emplace(colours_);
  return *classes_;
}

void SceneImage::forget() {
  for (auto* pyramid : {&grey, &colours_})
    if (!pyramid->empty()) pyramid->front().release();
  if (!levels.empty()) levels.front().forget();
}

}  // namespace mbncc::scene
