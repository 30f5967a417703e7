// SPDX-License-Identifier: BSD-3-Clause
// One lesson over the action: images, segmentation, review by the operator, storing.
#pragma once

#include <mbncc_vision/LearnObjectResult.h>
#include <sensor_msgs/Image.h>

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "mbncc/cell/demonstration.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/interactive_lesson.hpp"
#include "nodelets/learning/confirmation.hpp"
#include "nodelets/learning/image_feed.hpp"
#include "nodelets/learning/lesson_gauge.hpp"
#include "nodelets/learning/lesson_server.hpp"
#include "nodelets/library/shared_library.hpp"

namespace mbncc::nodelets {

/// Dependencies of a lesson; all outlive the lesson.
struct LessonTools {
  ImageFeed& images;
  SharedLibrary& library;
  Confirmation& confirmation;
  LearningConfig config;
  SearchConfig search;  ///< that will look for the object
  std::function<void(const cv::Mat&)> show_stage;
  std::function<void(const cv::Mat&)> show_preview;
  std::function<void(const cv::Mat&)>
      show_image;  ///< without annotations, published before its draft
  std::function<void(const mbncc_vision::LearnObjectResult&)> show_draft;
  std::function<void(const ObjectModel&, const cv::Mat& image)> show_score_map;
  const LessonGauge& gauge;
  std::string cell_name;  ///< stored with the object
};

/// An image to learn from, CV_8UC3.
struct LessonImage {
  cv::Mat image;
  std_msgs::Header header;
  std::uint64_t number = 0;  ///< number of its still period; 0: given with the goal
};

class LessonRun {
 public:
  LessonRun(LessonClient& client, const LessonTools& tools);

  /// Failures of images, region, operator and library are reported in the result.
  mbncc_vision::LearnObjectResult run();

 private:
  using Goal = mbncc_vision::LearnObjectGoal;
  using Result = mbncc_vision::LearnObjectResult;
  using Step = Demonstration::Step;

  Result teach_and_store();

  // Images.
  void take_images();
  void take_already_moved();
  bool waits_for_change() const;
  void take_before(const LessonImage& image);
  void calibrate_before();
  LessonImage given(const sensor_msgs::Image& message, const std::string& what) const;
  void wait_for_before();
  void wait_for_change();
  Step demonstrate(const std::optional<StillShot>& still);
  void wait_on();
  void watch(const std::function<Step(const ImageFeed::View&)>& look);
  void say(Step step);
  void say_silence(const ImageFeed::View& view);
  void ask_operator_to(std::uint8_t stage, double progress, const std::string& sentence);
  [[noreturn]] void fail_waiting(LearnError interruption, const ImageFeed::View& view) const;

  // Learning.
  Lesson lesson_of(const cv::Mat& after) const;
  void learn();
  void take_draft();
  void note_view();
  StageObserver observer();
  bool lies_there_yet() const;
  void judge() const;

  // The operator's check.
  Result review();
  Confirmation::Request ask_operator();
  void carry_out(const Confirmation::Request& command, Confirmation::Response& response);
  void edit(const Confirmation::Request& command, Confirmation::Response& response);
  void undo(Confirmation::Response& response);

  // The end.
  bool may_be_stored() const;
  Result store();
  std::string measure(ObjectModel& model) const;
  std::string lack(const LessonMeasures& measures) const;
  std::string second_view() const;
  ObjectModel save(ObjectModel model, std::string& lacking) const;
  Result describe(Result result, const ObjectModel& model) const;
  cv::Mat preview(const ObjectModel& model) const;

  void tell(std::uint8_t stage, double progress, const std::string& message,
            bool operator_action = false);
  [[noreturn]] void fail(LearnError error, const std::string& message = "",
                         const std::string& hint = "") const;
  void leave_if_interrupted() const;

  LessonClient& client_;
  const LessonTools& tools_;
  const Goal& goal_;
  const std::string name_;
  const ros::Time started_;
  Demonstration demonstration_;
  bool camera_moved_ = false;  // which is why the image before is of no use
  double followed_at_ = 0;     // [s] stamp of the image in which the camera was last looked for
  std::string asked_for_;      // of the operator, the last time
  LessonImage before_, after_;
  Calibration calibration_;  // of the image before
  std::optional<InteractiveLesson> draft_;
  LearnResult learned_;  // the draft's, compared with the library
};

}  // namespace mbncc::nodelets
