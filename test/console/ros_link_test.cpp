// SPDX-License-Identifier: BSD-3-Clause
// There is no master, so every call fails at once.
#include "console/ros_link.hpp"

#include <gtest/gtest.h>

#include <future>
#include <memory>

namespace mbncc::console {
namespace {

/// Holds the thread of the calls to the matching nodelet, as one that does not answer would.
class HungSearch {
 public:
  explicit HungSearch(RosLink& ros) {
    QObject::connect(
        &ros, &RosLink::all_found, &ros,
        [state = state_] {
          state->hangs.set_value();
          state->ends.get_future().wait();
        },
        Qt::DirectConnection);
    ros.find_all();
    state_->hangs.get_future().wait();
  }
  ~HungSearch() { state_->ends.set_value(); }

 private:
  struct State {
    std::promise<void> hangs, ends;
  };
  const std::shared_ptr<State> state_ = std::make_shared<State>();
};

TEST(RosLink, AnAnswerToALessonDoesNotWaitForAHungMatcher) {
  std::promise<bool> answered;
  RosLink ros;
  QObject::connect(
      &ros, &RosLink::confirmed, &ros, [&](bool success) { answered.set_value(success); },
      Qt::DirectConnection);
  const HungSearch hung(ros);
  ros.confirm({});
  EXPECT_FALSE(answered.get_future().get());  // reached only if it was called meanwhile
}

TEST(RosLink, ACalibrationDoesNotWaitForAHungMatcher) {
  std::promise<bool> kept;
  RosLink ros;
  QObject::connect(
      &ros, &RosLink::calibration_kept, &ros, [&](bool success) { kept.set_value(success); },
      Qt::DirectConnection);
  const HungSearch hung(ros);
  ros.keep_calibration({});
  EXPECT_FALSE(kept.get_future().get());
}

}  // namespace
}  // namespace mbncc::console
