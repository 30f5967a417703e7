// SPDX-License-Identifier: BSD-3-Clause
// Which of the cell's live pictures is shown: bare, or with what is found.
#pragma once

namespace mbncc::console {

class LivePicture {
 public:
  explicit LivePicture(double now = 0) : shown_at_(now) {}

  /// A picture has come, `searched`: with what was found in it. True when it is to be shown: while
  /// a lesson runs the bare ones, otherwise the searched ones, and bare ones where those fail to
  /// come. Times are in seconds of any one clock.
  bool take(bool searched, bool teaching, double now);

  /// [s] since a picture was shown.
  double age(double now) const { return now - shown_at_; }

 private:
  double shown_at_;
  double searched_at_ = -1e9;
};

}  // namespace mbncc::console
