// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_picture.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "imaging/pyramid.hpp"

namespace mbncc::scene {
namespace {

void check_type(const cv::Mat& picture) {
  if (picture.type() != CV_8UC3 && picture.type() != CV_8UC1)
    throw std::invalid_argument("a picture to search must be 8-bit colour or grey");
}

void check(const cv::Mat& picture) {
  constexpr int kSmallest = 16;
  check_type(picture);
  if (picture.cols < kSmallest || picture.rows < kSmallest)
    throw std::invalid_argument("a picture to search must have at least 16 x 16 pixels");
}

}  // namespace

cv::Mat grey_picture(const cv::Mat& picture) {
  check(picture);
  if (picture.type() == CV_8UC1) return picture;
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

bool is_grey(const cv::Mat& picture) {
  check_type(picture);
  if (picture.type() == CV_8UC1) return true;
  for (int y = 0; y < picture.rows; ++y) {
    const auto* row = picture.ptr<cv::Vec3b>(y);
    if (std::any_of(row, row + picture.cols,
                    [](const cv::Vec3b& p) { return p[0] != p[1] || p[1] != p[2]; }))
      return false;
  }
  return true;
}

ScenePicture::ScenePicture(const cv::Mat& picture, int top_level) {
  show(picture, top_level);
}

void ScenePicture::show(const cv::Mat& picture, int top_level) {
  check(picture);
  const bool in_colour = picture.type() == CV_8UC3;
  cv::cvtColor(picture, converted_, in_colour ? cv::COLOR_BGR2GRAY : cv::COLOR_GRAY2BGR);
  imaging::build_pyramid(in_colour ? converted_ : picture, top_level, grey);
  imaging::build_pyramid(in_colour ? picture : converted_, top_level, colours_);
  levels.resize(colours_.size());
  padded_.resize(grey.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    levels[level].show(colours_[level], static_cast<int>(level));
    if (!padded_[level]) padded_[level] = std::make_unique<PaddedCache<imaging::PaddedPicture>>();
    padded_[level]->forget();
  }
  classes_.reset();
}

const imaging::ClassPictures& ScenePicture::classes() const {
  const std::lock_guard<std::mutex> lock(sorting_);
  if (!classes_) classes_.emplace(colours_);
  return *classes_;
}

void ScenePicture::forget() {
  for (auto* pyramid : {&grey, &colours_})
    if (!pyramid->empty()) pyramid->front().release();
  if (!levels.empty()) levels.front().forget();
}

}  // namespace mbncc::scene
