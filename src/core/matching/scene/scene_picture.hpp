// SPDX-License-Identifier: BSD-3-Clause
// Data computed once per picture and shared by all objects.
#pragma once

#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "imaging/colour_bins.hpp"
#include "imaging/padded_picture.hpp"
#include "matching/scene/padded_cache.hpp"
#include "matching/scene/scene_level.hpp"

namespace mbncc::scene {

/// `picture` as grey: CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; else std::invalid_argument.
cv::Mat grey_picture(const cv::Mat& picture);

/// A grey picture, or one whose channels are equal everywhere, as of a grey camera.
bool is_grey(const cv::Mat& picture);

struct ScenePicture {
  ScenePicture() = default;
  ScenePicture(const cv::Mat& picture, int top_level);

  /// Sets `picture`, as for grey_picture(), reusing the memory of the last one.
  void show(const cv::Mat& picture, int top_level);
  /// Releases the caller's picture and keeps the memory.
  void forget();

  int top_level() const { return static_cast<int>(grey.size()) - 1; }
  cv::Size size() const { return grey.front().size(); }

  /// Of grey[level], with a margin of at least `margin` [px].
  std::shared_ptr<const imaging::PaddedPicture> padded(int level, int margin) const {
    return padded_[level]->get(grey[level], margin);
  }

  /// Input of the colour prefilters. Thread-safe.
  const imaging::ClassPictures& classes() const;

  std::vector<cv::Mat> grey;       ///< CV_8UC1 pyramid
  std::vector<SceneLevel> levels;  ///< as many

 private:
  cv::Mat converted_;  // from colour to grey or back
  std::vector<cv::Mat> colours_;
  std::vector<std::unique_ptr<PaddedCache<imaging::PaddedPicture>>> padded_;
  mutable std::mutex sorting_;
  mutable std::optional<imaging::ClassPictures> classes_;
};

}  // namespace mbncc::scene
