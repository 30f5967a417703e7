// SPDX-License-Identifier: BSD-3-Clause
// A simulated workshop with a library of taught objects, and a video search that watches it.
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
  int overlooked = 0;  ///< number of consecutive images in which it was missed
};

/// The workshop, its camera and its video search.
class Workshop {
 public:
  Workshop(int objects, int lying, int seed);

  /// Puts an object at a free place.
  void add(int index);

  /// A pose at which it overlaps no other object; object `self` is ignored.
  Pose2D free_pose(const sim::SceneObject& drawing, int self = -1);

  /// Renders and searches the next image; returns the thread CPU time of the search [ms].
  double show(double light = 1, const std::optional<sim::Arm>& arm = {});

  /// Searches the same image completely; returns the thread CPU time [ms].
  double search_whole();

  /// The match within 3 px and 3 degrees of the object; null if it was not found.
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

/// Every 60 images an arm comes from below. It carries an object to another place, or only reaches
/// over some objects.
class Story {
 public:
  explicit Story(Workshop& workshop) : workshop_(workshop) {}

  /// The arm in the next image; also moves the object that it holds.
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

/// True if the arm or its shadow may cover the object.
bool is_covered(const Lying& one, const std::optional<sim::Arm>& arm);

}  // namespace mbncc::bench
