// SPDX-License-Identifier: BSD-3-Clause
// Watches the live cell: still or moving, and which still pictures show the scene before and after
// something was taken away. An arm that pauses in view makes still pictures too; they are told by
// their change reaching the picture's edge.
#pragma once

#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>

namespace mbncc {

/// A picture taken while the scene was still.
struct StillShot {
  cv::Mat picture;           ///< as given to update()
  double stamp = 0;          ///< [s]
  std::uint64_t number = 0;  ///< counts the still periods, from 1
};

enum class SceneChange {
  kNone,
  kInside,   ///< something came, went or moved inside the picture
  kAtBorder  ///< the change reaches the picture's edge: an arm in view, or an object half outside
};

/// How two pictures of one camera differ, seen coarsely.
struct SceneDifference {
  SceneChange change = SceneChange::kNone;
  cv::Mat changed;      ///< CV_8UC1 of the pictures' size, 255 where they differ beyond noise
  double fraction = 0;  ///< [0..1] changed part of the picture
  double exposure = 1;  ///< factor between the pictures, >= 1; evened out before they are compared
};

/// Judges two pictures of one camera (CV_8UC3, same size), coarsely: for when to look closer, not
/// for where the object is.
SceneDifference scene_difference(const cv::Mat& before, const cv::Mat& after);

/// Its `change` alone.
SceneChange scene_change(const cv::Mat& before, const cv::Mat& after);

/// Fed with every picture of one camera in turn. Costs about a millisecond per picture. Keeps the
/// pictures it is given, so they must not be written to afterwards.
class SceneWatch {
 public:
  /// `still_time` [s] without motion makes the scene still.
  explicit SceneWatch(double still_time = 0.5);

  /// Takes the next picture, CV_8UC3. A stamp [s] that jumps back or another picture size starts
  /// the watch anew. Throws std::invalid_argument for an empty picture or another type.
  void update(double stamp, const cv::Mat& picture);

  /// Forgets everything but the count of still periods.
  void reset();

  /// A picture of the present still period, not quite the newest so that it shows nothing of a
  /// motion about to be noticed; none while something moves.
  std::optional<StillShot> still() const;

  /// The picture to teach from when the object has been taken away already: of the latest earlier
  /// still period that differs from the present one inside the picture. None while something moves
  /// or when nothing has changed.
  std::optional<StillShot> before_change() const;

 private:
  void begin_candidate(double stamp, const cv::Mat& small);
  void keep_shot(double stamp, const cv::Mat& picture);
  void end_period();

  double still_time_;
  cv::Size size_;
  double last_stamp_ = 0;
  cv::Mat anchor_;           // CV_32FC1 small picture that the next ones are compared with
  double anchor_stamp_ = 0;  // [s] since when nothing has moved
  bool still_ = false;
  std::uint64_t periods_ = 0;
  StillShot waiting_;           // of the present period, to become settled_
  StillShot settled_;           // of the present period, old enough not to show the next motion
  std::deque<StillShot> past_;  // settled pictures of earlier periods, oldest first
};

}  // namespace mbncc
