// SPDX-License-Identifier: BSD-3-Clause
// A simulated scene that a VideoSearch watches, for its tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/cell/video_search.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {

constexpr double kFrameTime = 1. / 30;  // [s]
const cv::Size kSize(400, 300);         // [px]

inline std::shared_ptr<const ObjectModel> learned(const sim::SceneObject& drawing,
                                                  const std::string& name) {
  sim::SceneConfig config;
  config.size = kSize;
  const sim::Scene scene(config);
  const sim::Placed placed{drawing, {200, 150, 0}};
  auto model = std::make_shared<ObjectModel>();
  model->name = name;
  model->views = {crop_view(scene.render({placed}, 1), scene.true_map(placed), placed.pose)};
  return model;
}

inline sim::SceneConfig scene_config() {
  sim::SceneConfig config;
  config.size = kSize;
  return config;
}

/// Three taught objects, some of which lie in the image.
class VideoSearchTest : public ::testing::Test {
 protected:
  VideoSearchTest() {
    for (int i = 0; i < 3; ++i) models_.push_back(learned(drawing(i), name(i)));
    matcher_.set_objects(models_);
  }

  static std::string name(int i) { return "part" + std::to_string(i); }
  static sim::SceneObject drawing(int i) {
    return {static_cast<std::uint64_t>(11 + i), 60.0 + 5 * i, 1.5};
  }

  void put(int i, const Pose2D& pose) { placed_.push_back({drawing(i), pose}); }

  SearchResult show(const std::optional<sim::Arm>& arm = {}, double gain = 1) {
    image_ = scene_.render(placed_, frames_, arm) * gain;
    return video_.find(matcher_, kFrameTime * frames_++, image_);
  }

  SearchResult show_many(int count) {
    for (int i = 1; i < count; ++i) show();
    return show();
  }

  static const Match* of(const SearchResult& result, int i) {
    for (const auto& match : result.matches)
      if (match.name == name(i)) return &match;
    return nullptr;
  }

  static bool is_at(const Match* match, const Pose2D& pose) {
    return match && cv::norm(match->pose.position() - pose.position()) < 1.5 &&
           angle_distance(match->pose.theta, pose.theta) < to_radians(3);
  }

  std::vector<std::shared_ptr<const ObjectModel>> models_;
  Matcher matcher_;
  VideoSearch video_;
  sim::Scene scene_{scene_config()};
  std::vector<sim::Placed> placed_;
  cv::Mat image_;
  int frames_ = 0;
};

const Pose2D kLeft{100.3, 90.2, 0.4}, kRight{300.6, 200.7, -1.2};

}  // namespace mbncc
