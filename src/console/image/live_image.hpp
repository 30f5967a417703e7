// SPDX-License-Identifier: BSD-3-Clause
// Selects the live image to show: the plain one, or the one with detections.
#pragma once

namespace mbncc::console {

class LiveImage {
 public:
  explicit LiveImage(double now = 0) : shown_at_(now) {}

  /// Call this for each image; `searched`: with its detections. Returns true if the image shall be
  /// shown: plain images during a lesson, otherwise searched ones, or plain ones if no searched
  /// ones arrive. Times are in seconds of any one clock.
  bool take(bool searched, bool teaching, double now);

  /// [s] since the last image was shown.
  double age(double now) const { return now - shown_at_; }

 private:
  double shown_at_;
  double searched_at_ = -1e9;
};

}  // namespace mbncc::console
