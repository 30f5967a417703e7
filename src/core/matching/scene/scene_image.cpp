// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_image.hpp"

#include <opencv2/imgproc.hpp>

#include "imaging/pyramid.hpp"
#include "matching/scene/grey_image.hpp"

namespace mbncc::scene {
SceneImage::SceneImage(const cv::Mat& image, int top_level) {
  set_image(image, top_level);
}

void SceneImage::set_image(const cv::Mat& image, int top_level) {
  check_searchable(image);
  const bool in_colour = image.type() == CV_8UC3;
  cv::cvtColor(image, converted_, in_colour ? cv::COLOR_BGR2GRAY : cv::COLOR_GRAY2BGR);
  imaging::build_pyramid(in_colour ? converted_ : image, top_level, grey);
  imaging::build_pyramid(in_colour ? image : converted_, top_level, colours_);
  levels.resize(colours_.size());
  padded_.resize(grey.size());
  for (std::size_t level = 0; level < levels.size(); ++level) {
    levels[level].set_image(colours_[level], static_cast<int>(level));
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
