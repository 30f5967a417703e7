// SPDX-License-Identifier: BSD-3-Clause
// Classifies a live scene as still or moving, and selects still images from before and after an
// object was taken away. Images of an arm that pauses in view are recognised by a change that
// reaches the image's edge.
#pragma once

#include <cstdint>
#include <deque>
#include <opencv2/core.hpp>
#include <optional>

namespace mbncc {

/// An image taken while the scene was still.
struct StillShot {
  cv::Mat image;             ///< as given to update()
  double stamp = 0;          ///< [s]
  std::uint64_t number = 0;  ///< counts the still periods, from 1
};

/// Processes every image of one camera in turn, in about a millisecond each. Keeps references to
/// the images, so they must not be modified afterwards.
class SceneWatch {
 public:
  /// The scene is still after `still_time` [s] without motion.
  explicit SceneWatch(double still_time = 0.5);

  /// Processes the next image, CV_8UC3. A stamp [s] that jumps back or another image size
  /// resets the watch. Throws std::invalid_argument for an empty image or another type.
  void update(double stamp, const cv::Mat& image);

  /// Resets everything except the count of still periods.
  void reset();

  /// An image of the current still period, slightly delayed so that it shows no motion that is not
  /// yet detected; none while something moves.
  std::optional<StillShot> still() const;

  /// The image before, if the object has been taken away already: from the latest earlier still
  /// period that differs from the current one inside the image. None while something moves or if
  /// nothing has changed.
  std::optional<StillShot> before_change() const;

 private:
  void begin_candidate(double stamp, const cv::Mat& small);
  void keep_shot(double stamp, const cv::Mat& image);
  void end_period();

  double still_time_;
  cv::Size size_;
  double last_stamp_ = 0;
  cv::Mat anchor_;           // CV_32FC1 small image that the next ones are compared with
  double anchor_stamp_ = 0;  // [s] stamp since which nothing has moved
  bool still_ = false;
  std::uint64_t periods_ = 0;
  StillShot waiting_;           // of the current period, to become settled_
  StillShot settled_;           // of the current period, old enough not to show the next motion
  std::deque<StillShot> past_;  // settled images of earlier periods, oldest first
};

}  // namespace mbncc
