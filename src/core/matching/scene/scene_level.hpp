// SPDX-License-Identifier: BSD-3-Clause
// An image at one pyramid level, smoothed and with its edges, computed lazily in tiles.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/padded_cache.hpp"
#include "matching/scene/response_maps.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::scene {

/// Pixels of a level, prepared in the requested region only. Valid until another image is set.
struct PreparedPixels {
  const cv::Mat& colour;  ///< CV_8UC3, smoothed
  const cv::Mat& edges;   ///< CV_8SC2, see gradient_orientation.hpp

  cv::Size size() const { return colour.size(); }
};

/// At full resolution only a small part of an image is needed, around the candidates of coarser
/// levels. Tiles are therefore prepared on demand, once each. Thread-safe.
class SceneLevel {
 public:
  SceneLevel();
  SceneLevel(const cv::Mat& image, int level);

  /// Sets `image`, CV_8UC3, reusing the memory of the last one; it is smoothed slightly against
  /// noise, more at level 0.
  void set_image(const cv::Mat& image, int level);
  /// Releases the image and keeps the memory.
  void forget() { image_.release(); }

  cv::Size size() const { return colour_.size(); }

  PreparedPixels whole() const;
  /// The surroundings of `pose` within `reach` [px] plus some slack.
  PreparedPixels around(const Pose2D& pose, double reach) const;

  /// Response maps of all edges, with a margin of at least `margin` [px].
  std::shared_ptr<const ResponseMaps> responses(int margin) const;

 private:
  struct Tiles {
    explicit Tiles(std::size_t count) : ready(count) {}

    std::vector<std::atomic<bool>> ready;
    std::mutex preparing;
  };

  void prepare(const cv::Rect& region) const;
  void prepare_tile(int column, int row) const;

  cv::Mat image_;
  // Written tile by tile, under the lock of tiles_; a tile is read only when it is marked as ready.
  mutable cv::Mat colour_, edges_;
  int level_ = 0, tile_columns_ = 0;
  std::unique_ptr<Tiles> tiles_;
  std::unique_ptr<PaddedCache<ResponseMaps>> responses_;
};

}  // namespace mbncc::scene
