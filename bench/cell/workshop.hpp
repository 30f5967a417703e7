// SPDX-License-Identifier: BSD-3-Clause
// A simulated workshop with a library of taught objects, and who watches it.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mbncc/cell/video_search.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc::bench {

constexpr double kFrameTime = 1. / 30;  // [s]

/// An object in the image.
struct Lying {
  int index;
  sim::Placed placed;
  bool held = false;
  int overlooked = 0;  ///< images in a row
};

/// The workshop, its camera and who watches it.
class Workshop {
 public:
  Workshop(int objects, int lying, int seed);

  /// Puts an object to a free place.
  void add(int index);

  /// A place where nothing lies; the object itself does not count.
  Pose2D free_pose(const sim::SceneObject& drawing, int self = -1);

  /// Renders and searches the next image; thread CPU ms of the search.
  double show(double light = 1, const std::optional<sim::Arm>& arm = {});

  /// Searches the same image whole; thread CPU ms.
  double search_whole();

  /// Within 3 px and 3 degrees; null: not found.
  const Match* right_one(const SearchResult& result, const Lying& one) const;

  const SearchResult& result() const { return result_; }
  const SearchResult& whole() const { return whole_; }
  std::vector<Lying>& lying() { return lying_; }
  cv::RNG& random() { return random_; }

 private:
  cv::RNG random_;
  sim::Scene scene_;
  std::vector<sim::SceneObject> drawings_;
  Matcher matcher_;
  VideoSearch video_;
  std::vector<Lying> lying_;
  cv::Mat image_;
  SearchResult result_, whole_;
  std::uint64_t frames_ = 0;
};

/// Every 60 images an arm comes from below, and carries an object elsewhere, or only reaches over
/// some.
class Story {
 public:
  explicit Story(Workshop& workshop) : workshop_(workshop) {}

  /// The arm in the next image; what it holds has been moved.
  std::optional<sim::Arm> step();

 private:
  void begin();
  Pose2D grip_at(double share) const;
  void carry(sim::Arm& arm, int beat);

  Workshop& workshop_;
  int count_ = 0;
  Lying* held_ = nullptr;
  Pose2D from_, to_;
};

/// The arm or its shadow may lie on the object.
bool is_covered(const Lying& one, const std::optional<sim::Arm>& arm);

}  // namespace mbncc::bench
