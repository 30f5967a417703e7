// SPDX-License-Identifier: BSD-3-Clause
// A camera's calibration from live pictures of a chessboard.
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
  /// The picture is parted into so many fields a side, which the board should have been in.
  static constexpr int kFields = 4;

  BoardCalibration() = default;
  /// `size` [px] of the camera's pictures.
  BoardCalibration(const Board& board, cv::Size size) : board_(board), size_(size) {}

  enum class Seen {
    kNothing,  ///< no whole board
    kKnown,    ///< much as in a picture that was taken
    kTaken
  };
  /// `picture`: CV_8UC3, perhaps shrunk.
  Seen take(const cv::Mat& picture);

  /// [px] of the camera's picture, of the board seen last.
  const std::vector<cv::Point2f>& corners() const { return corners_; }
  std::size_t views() const { return views_.size(); }
  int covered() const { return static_cast<int>(fields_.size()); }
  /// There are views enough, and they cover the picture.
  bool suffices() const;
  /// What to do next.
  std::string advice(Seen seen) const;

  struct Result {
    sensor_msgs::CameraInfo info;
    double error_px = 0;  ///< RMS of corners projected back
    double error_mm = 0;  ///< likewise, on the board
  };
  /// With at least three views.
  Result solve() const;

 private:
  Board board_;
  cv::Size size_;
  std::vector<cv::Point2f> corners_;
  std::vector<std::vector<cv::Point2f>> views_;
  std::set<int> fields_;
};

}  // namespace mbncc::console
