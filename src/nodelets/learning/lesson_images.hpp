// SPDX-License-Identifier: BSD-3-Clause
// The images of a lesson: given with the goal, or taken live while the operator takes the object
// away.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <optional>
#include <string>

#include "mbncc/cell/demonstration.hpp"
#include "nodelets/learning/image_feed.hpp"
#include "nodelets/learning/lesson_feedback.hpp"
#include "nodelets/learning/lesson_gauge.hpp"

namespace mbncc::nodelets {

class LessonImages {
 public:
  /// The arguments must outlive this object.
  LessonImages(const mbncc_vision::LearnObjectGoal& goal, ImageFeed& feed, const LessonGauge& gauge,
               LessonFeedback& feedback);

  /// Returns when the images that the goal needs are available; ends the lesson if they cannot be
  /// obtained.
  void take();

  /// Whether the image after can be replaced by a later one.
  bool can_wait_for_next_change() const;

  /// Waits for another change, because the current images do not show that an object has left.
  /// Things that were put down belong to the scene from now on.
  void wait_for_next_change();

  const LessonImage& before() const { return before_; }
  const LessonImage& after() const { return after_; }  ///< empty: the goal's mode needs none

  /// The calibration of the image before. It is looked up again if it was unknown, because tf or
  /// camera_info may arrive slightly later than the image.
  const Calibration& calibration();

 private:
  using Step = Demonstration::Step;

  LessonImage given(const sensor_msgs::Image& message, const std::string& what) const;
  void take_already_moved();
  void take_before(const LessonImage& image);
  void calibrate();
  void wait_for_before();
  void wait_for_change();
  Step demonstrate(const std::optional<StillShot>& still);
  void watch(const std::function<Step(const ImageFeed::State&)>& next_step);
  void report_step(Step step);
  void report_missing_images(const ImageFeed::State& state);
  [[noreturn]] void fail_waiting(LearnError interruption, const ImageFeed::State& state) const;

  const mbncc_vision::LearnObjectGoal& goal_;
  ImageFeed& feed_;
  const LessonGauge& gauge_;
  LessonFeedback& feedback_;
  Demonstration demonstration_;
  bool camera_moved_ = false;     // which made the image before useless
  double camera_checked_at_ = 0;  // [s] stamp of the last image checked for camera motion
  LessonImage before_, after_;
  Calibration calibration_;  // of the image before
};

}  // namespace mbncc::nodelets
