// SPDX-License-Identifier: BSD-3-Clause
// Where a watched picture differs from what it looked like when it was searched there last.
#pragma once

#include <deque>
#include <opencv2/core.hpp>
#include <vector>

namespace mbncc {

/// Compares the pictures of one still camera by cells of kCell x kCell pixels with a reference that
/// remembers each cell as it was when it was taken to the records. Exposure that differs as a whole
/// counts as no change, nor does light that drifts slowly. Costs about 0.1 ms per 640 x 480 picture
/// in which nothing changes.
class ChangeMap {
 public:
  static constexpr int kCell = 4;  ///< [px]

  /// Takes the next picture, stamped `stamp` [s], CV_8UC3 or CV_8UC1. The first one, or one of
  /// another size or type, is taken to the records as it is. Throws std::invalid_argument for
  /// another type or an empty picture.
  void update(double stamp, const cv::Mat& picture);

  /// Forgets the records.
  void reset();

  /// The newest picture differs from the records within `region` [px].
  bool touches(const cv::Rect& region) const;

  /// Patches [px] that differ and have come to rest, or have been restless for long; update() has
  /// taken them to the records, so each is told once.
  const std::vector<cv::Rect>& settled() const { return settled_; }

  /// So much differs that the camera was pushed or the light switched.
  bool is_upset() const { return upset_; }

 private:
  struct Earlier {
    double stamp;  // [s]
    cv::Mat cells;
  };

  void drop_outdated(double stamp);
  void compare(double stamp, const cv::Mat& cells);
  void settle(double stamp, const cv::Mat& cells);
  cv::Mat stirring_cells(const cv::Mat& cells) const;
  void take_to_records(const cv::Mat& cells, const cv::Mat& which);

  cv::Mat records_;              // CV_32FC3 or CV_32FC1, one pixel per cell
  std::deque<Earlier> earlier_;  // 8 bits, oldest first
  cv::Mat changed_;              // CV_8UC1, 255: differs from the records
  cv::Scalar gain_;              // of the newest picture against the records, per channel
  double calm_at_ = 0;           // [s] when no patch was restless
  bool upset_ = false;
  std::vector<cv::Rect> settled_;
};

}  // namespace mbncc
