// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/scene_level.hpp"

#include <cmath>

#include "imaging/gradient_orientation.hpp"

namespace mbncc::scene {
namespace {

constexpr int kTile = 64;  // [px]

int tiles_along(int pixels) {
  return (pixels + kTile - 1) / kTile;
}

}  // namespace

SceneLevel::SceneLevel() : responses_(std::make_unique<PaddedCache<ResponseMaps>>()) {}

SceneLevel::SceneLevel(const cv::Mat& image, int level) : SceneLevel() {
  set_image(image, level);
}

void SceneLevel::set_image(const cv::Mat& image, int level) {
  colour_.create(image.size(), CV_8UC3);
  edges_.create(image.size(), CV_8SC2);
  image_ = image;
  level_ = level;
  tile_columns_ = tiles_along(image.cols);
  tiles_ =
      std::make_unique<Tiles>(static_cast<std::size_t>(tile_columns_) * tiles_along(image.rows));
  responses_->forget();
}

std::shared_ptr<const ResponseMaps> SceneLevel::responses(int margin) const {
  return responses_->get(whole().edges, margin);
}

PreparedPixels SceneLevel::whole() const {
  prepare(cv::Rect({0, 0}, size()));
  return {colour_, edges_};
}

PreparedPixels SceneLevel::around(const Pose2D& pose, double reach) const {
  constexpr int kSlack = 8;
  constexpr double kFar = 1e6;  // outside every image
  if (!(std::abs(pose.x) < kFar && std::abs(pose.y) < kFar)) return {colour_, edges_};
  const int radius = static_cast<int>(std::ceil(reach)) + kSlack;
  const cv::Point middle(cvFloor(pose.x), cvFloor(pose.y));
  prepare(cv::Rect(middle.x - radius, middle.y - radius, 2 * radius + 1, 2 * radius + 1));
  return {colour_, edges_};
}

void SceneLevel::prepare(const cv::Rect& region) const {
  const cv::Rect inside = region & cv::Rect({0, 0}, size());
  for (int row = inside.y / kTile; row < tiles_along(inside.br().y); ++row)
    for (int column = inside.x / kTile; column < tiles_along(inside.br().x); ++column)
      if (!tiles_->ready[row * tile_columns_ + column].load(std::memory_order_acquire))
        prepare_tile(column, row);
}

void SceneLevel::prepare_tile(int column, int row) const {
  const std::lock_guard<std::mutex> lock(tiles_->preparing);
  auto& ready = tiles_->ready[row * tile_columns_ + column];
  if (ready.load(std::memory_order_relaxed)) return;
  const cv::Rect tile(column * kTile, row * kTile, kTile, kTile);
  imaging::smooth_and_find_edges(image_, tile & cv::Rect({0, 0}, size()), level_ == 0 ? 0.9 : 0.6,
                                 colour_, edges_);
  ready.store(true, std::memory_order_release);
}

}  // namespace mbncc::scene
