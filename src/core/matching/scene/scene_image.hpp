// SPDX-License-Identifier: BSD-3-Clause
// Data computed once per image and shared by all objects.
#pragma once

#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "imaging/colour_bins.hpp"
#include "imaging/padded_image.hpp"
#include "matching/scene/padded_cache.hpp"
#include "matching/scene/scene_level.hpp"

namespace mbncc::scene {

struct SceneImage {
  SceneImage() = default;
  SceneImage(const cv::Mat& image, int top_level);

  /// Sets `image`, which must meet check_searchable(), and reuses the memory of the last one.
  void set_image(const cv::Mat& image, int top_level);
  /// Releases the caller's image and keeps the memory.
  void forget();

  int top_level() const { return static_cast<int>(grey.size()) - 1; }
  cv::Size size() const { return grey.front().size(); }

  /// grey[level] with a margin of at least `margin` [px]. Thread-safe.
  std::shared_ptr<const imaging::PaddedImage> padded(int level, int margin) const {
    return padded_[level]->get(grey[level], margin);
  }

  /// Colour classes, the input of the colour prefilters. Thread-safe.
  const imaging::ClassImages& classes() const;

  std::vector<cv::Mat> grey;       ///< CV_8UC1 pyramid
  std::vector<SceneLevel> levels;  ///< one per level of `grey`

 private:
  cv::Mat converted_;  // from colour to grey or back
  std::vector<cv::Mat> colours_;
  std::vector<std::unique_ptr<PaddedCache<imaging::PaddedImage>>> padded_;
  mutable std::mutex sorting_;
  mutable std::optional<imaging::ClassImages> classes_;
};

}  // namespace mbncc::scene
