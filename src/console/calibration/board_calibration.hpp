// SPDX-License-Identifier: BSD-3-Clause
// Calibrates a camera from live images of a chessboard.
#pragma once

#include <sensor_msgs/CameraInfo.h>

#include <opencv2/core.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace mbncc::console {

struct Board {
  int columns = 9, rows = 6;  ///< inner corners
  double square = 0.025;      ///< [m]
};

class BoardCalibration {
 public:
  /// Number of fields per side of the image that the board should cover.
  static constexpr int kFields = 4;

  BoardCalibration() = default;
  /// `size` [px] of the camera's images.
  BoardCalibration(const Board& board, cv::Size size) : board_(board), size_(size) {}

  enum class Seen {
    kNothing,  ///< no complete board
    kKnown,    ///< too similar to a recorded image
    kTaken
  };
  /// `image`: CV_8UC3, possibly scaled down.
  Seen take(const cv::Mat& image);

  /// [px] corners of the last visible board in the camera's image.
  const std::vector<cv::Point2f>& corners() const { return corners_; }
  std::size_t views() const { return views_.size(); }
  int covered() const { return static_cast<int>(fields_.size()); }
  /// Covered fields, numbered row by row.
  const std::set<int>& fields() const { return fields_; }
  /// [px] of the recorded boards: their outer inner corners, in order around the board.
  std::vector<std::vector<cv::Point2f>> outlines() const;
  /// [px] outline of the last visible board; empty: none.
  std::vector<cv::Point2f> outline() const;
  cv::Size size() const { return size_; }
  /// There are enough views, and they cover the image.
  bool suffices() const;
  /// The next instruction.
  std::string advice(Seen seen) const;

  struct Result {
    sensor_msgs::CameraInfo info;
    double error_px = 0;         ///< RMS reprojection error of the corners
    double error_mm = 0;         ///< the same in mm on the board
    double focal_deviation = 0;  ///< standard deviation of the focal length, divided by it
    /// The views determine the focal length; those of a board that was never tilted do not.
    bool determined() const { return focal_deviation < 0.01; }
  };
  /// Needs at least three views.
  Result solve() const;

 private:
  std::vector<cv::Point2f> outline_of(const std::vector<cv::Point2f>& corners) const;

  Board board_;
  cv::Size size_;
  std::vector<cv::Point2f> corners_;
  std::vector<std::vector<cv::Point2f>> views_;
  std::set<int> fields_;
};

}  // namespace mbncc::console
