// SPDX-License-Identifier: BSD-3-Clause
// A picture at one pyramid level, smoothed and with its edges, worked out where it is looked at.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/scene/padded_cache.hpp"
#include "matching/scene/response_maps.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc {

/// At full resolution little of a picture is ever looked at: the search comes down from coarser
/// levels with a few candidates. So tiles are prepared when they are asked for, once each; several
/// threads may ask at a time.
class SceneLevel {
 public:
  SceneLevel();
  SceneLevel(const cv::Mat& picture, int level);

  /// Takes `picture`, CV_8UC3, in the memory of the last one; it is smoothed a little against
  /// noise, more at level 0.
  void show(const cv::Mat& picture, int level);
  /// Lets the picture go, and keeps the memory.
  void forget() { picture_.release(); }

  cv::Size size() const { return colour.size(); }

  /// Prepares all of it.
  void prepare() const { prepare(cv::Rect({0, 0}, size())); }
  /// Prepares what lies within `reach` [px] and some slack about `pose`.
  void prepare_around(const Pose2D& pose, double reach) const;

  /// Of all of its edges, with a margin of at least `margin` [px].
  std::shared_ptr<const ResponseMaps> responses(int margin) const;

  // Valid only where prepared.
  cv::Mat colour;  ///< CV_8UC3, smoothed
  cv::Mat edges;   ///< CV_8SC2, see edge_picture.hpp

 private:
  struct Tiles {
    explicit Tiles(std::size_t count) : ready(count) {}

    std::vector<std::atomic<bool>> ready;
    std::mutex preparing;
  };

  void prepare(const cv::Rect& region) const;
  void prepare_tile(int column, int row) const;

  cv::Mat picture_;
  int level_ = 0, tile_columns_ = 0;
  std::unique_ptr<Tiles> tiles_;
  std::unique_ptr<PaddedCache<ResponseMaps>> responses_;
};

}  // namespace mbncc
