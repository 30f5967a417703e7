// SPDX-License-Identifier: BSD-3-Clause
// Detects where an image differs from its state at the last search.
#pragma once

#include <deque>
#include <opencv2/core.hpp>
#include <vector>

namespace mbncc {

/// Compares the images of one still camera by cells of kCell x kCell pixels with a reference that
/// stores each cell as it was last recorded. A global difference of exposure and slow drift of the
/// light do not count as change. Costs about 0.1 ms per 640 x 480 image in which nothing changes.
class ChangeMap {
 public:
  static constexpr int kCell = 4;  ///< [px]

  /// Processes the next image, stamped `stamp` [s], CV_8UC3 or CV_8UC1. The first one, or one of
  /// another size or type, becomes the reference. Throws std::invalid_argument for another type or
  /// an empty image.
  void update(double stamp, const cv::Mat& image);

  /// Whether the newest image differs from the reference within `region` [px].
  bool touches(const cv::Rect& region) const;

  /// Changed patches [px] that are at rest again, or have been changing for too long. update() has
  /// copied them into the reference, so each is reported once.
  const std::vector<cv::Rect>& settled() const { return settled_; }

  /// Whether so much differs that the camera was probably moved or the light switched.
  bool has_changed_globally() const { return changed_globally_; }

 private:
  struct Earlier {
    double stamp;  // [s]
    cv::Mat cells;
  };

  void drop_outdated(double stamp);
  void compare(double stamp, const cv::Mat& cells);
  void settle(double stamp, const cv::Mat& cells);
  cv::Mat moving_cells(const cv::Mat& cells) const;
  void update_reference(const cv::Mat& cells, const cv::Mat& which);

  cv::Mat references_;           // CV_32FC3 or CV_32FC1, one pixel per cell
  std::deque<Earlier> earlier_;  // cells of earlier images, 8 bits, oldest first
  cv::Mat changed_;              // CV_8UC1, 255: differs from the reference
  cv::Scalar gain_;              // of the newest image relative to the reference, per channel
  double rested_at_ = 0;         // [s] last time without a changing patch
  bool changed_globally_ = false;
  std::vector<cv::Rect> settled_;
};

}  // namespace mbncc
