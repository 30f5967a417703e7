// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_images.hpp"

#include <mbncc_vision/LearnObjectFeedback.h>

#include <chrono>
#include <thread>

#include "mbncc/cell/camera_motion.hpp"
#include "nodelets/conversion/images.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;
using Goal = mbncc_vision::LearnObjectGoal;

constexpr std::chrono::milliseconds kPollInterval{30};  // between two checks of the live scene
constexpr int kChecksPerMessage = 15;  // number of checks between two messages to the operator

constexpr double kSilentCamera = 2;  // [s] without an image before the operator is informed

const char* const kCameraMoved =
    "The camera has moved; the lesson continues with the current image. Fasten the camera, make "
    "sure that the object is in view, then take it away.";
const char* const kCameraMovedSinceGiven =
    "The camera has moved since the given image before was taken. Put the camera back, or teach "
    "with a new image.";

const char* removal_sentence(Demonstration::RestartReason why) {
  using RestartReason = Demonstration::RestartReason;
  switch (why) {
    case RestartReason::kLight:
      return "The light has changed; the lesson continues with the current image. Take the "
             "object "
             "away now.";
    case RestartReason::kEdgeLeft:
      return "The arm or hand at the image's edge has left; the lesson continues with the "
             "current image. If the object is gone as well, put it back fully into view; then "
             "take it away.";
    case RestartReason::kEverything:
      return "Nearly everything has changed, as when the camera is moved; the lesson continues "
             "with the current image. Make sure that the object is in view, then take it away.";
    case RestartReason::kPutDown:
      return "No object has left its place; what was put down now belongs to the scene. Take the "
             "object farther away or out of the image.";
    default:
      return "Take the object away now.";
  }
}

LessonImage image_of(const StillShot& shot, const std::string& frame_id) {
  LessonImage image{shot.image, {}, shot.number};
  image.header.stamp.fromSec(shot.stamp);
  image.header.frame_id = frame_id;
  return image;
}

}  // namespace

LessonImages::LessonImages(const Goal& goal, ImageFeed& feed, const LessonGauge& gauge,
                           LessonFeedback& feedback)
    : goal_(goal), feed_(feed), gauge_(gauge), feedback_(feedback) {}

void LessonImages::take() {
  const bool change = goal_.mode == Goal::CHANGE;
  if (is_given(goal_.before)) {
    take_before(given(goal_.before, "before"));
    demonstration_ = Demonstration(before_.image);
  }
  if (change && is_given(goal_.after)) after_ = given(goal_.after, "after");
  if (change && goal_.already_moved && before_.image.empty()) return take_already_moved();
  if (before_.image.empty()) wait_for_before();
  if (change && after_.image.empty()) wait_for_change();
}

void LessonImages::take_before(const LessonImage& image) {
  before_ = image;
  calibrate();
}

void LessonImages::calibrate() {
  calibration_ = gauge_.calibrate_image(goal_.camera_info, before_.header, before_.image.size());
}

const Calibration& LessonImages::calibration() {
  if (!calibration_.platform) calibrate();
  return calibration_;
}

bool LessonImages::can_wait_for_next_change() const {
  return goal_.mode == Goal::CHANGE && !is_given(goal_.after) && !goal_.already_moved;
}

LessonImage LessonImages::given(const sensor_msgs::Image& message, const std::string& what) const {
  const Decoded decoded = decode_image(message, feed_.white_level());
  if (!decoded) end_lesson(LearnError::kEncoding, "Image " + what + ": " + decoded.fault + ".");
  return {decoded.image, message.header, 0};
}

void LessonImages::take_already_moved() {
  if (after_.image.empty())
    watch([this](const ImageFeed::State& state) {
      if (!state.still) return Step::kWaitStill;
      after_ = image_of(*state.still, state.header.frame_id);
      return Step::kReady;
    });
  const auto before = feed_.before_change();
  if (!before)
    end_lesson(LearnError::kNoChange, "Nothing in the camera's view has changed recently.",
               "Teach without already_moved, and take the object away when asked.");
  take_before(image_of(*before, after_.header.frame_id));
}

void LessonImages::wait_for_before() {
  watch([this](const ImageFeed::State& state) {
    if (demonstration_.update(state.still) == Step::kWaitStill) return Step::kWaitStill;
    take_before(image_of(demonstration_.before(), state.header.frame_id));
    return Step::kReady;
  });
}

void LessonImages::wait_for_change() {
  watch([this](const ImageFeed::State& state) {
    if (state.still && state.still->image.size() != before_.image.size())
      end_lesson(LearnError::kImageMismatch);
    const Step step = demonstrate(state.still);
    if (demonstration_.before().image.data != before_.image.data)
      take_before(image_of(demonstration_.before(), state.header.frame_id));
    if (step == Step::kReady) after_ = image_of(demonstration_.after(), state.header.frame_id);
    return step;
  });
}

/// Processes the newest still image. If the camera has moved, the image before is useless and,
/// unless the goal contains it, replaced. Something that reaches in from the edge leaves it valid.
LessonImages::Step LessonImages::demonstrate(const std::optional<StillShot>& still) {
  const cv::Mat was = demonstration_.before().image;
  const Step step = demonstration_.update(still);
  const cv::Mat is = demonstration_.before().image;
  if (is.data != was.data) camera_moved_ = camera_moved(was, is);
  if (step != Step::kAtBorder || still->stamp == camera_checked_at_) return step;
  camera_checked_at_ = still->stamp;
  camera_moved_ = camera_moved(is, still->image);
  if (!camera_moved_ || is_given(goal_.before)) return step;
  demonstration_ = Demonstration();
  demonstration_.update(still);
  return Step::kWaitRemoval;
}

void LessonImages::wait_for_next_change() {
  camera_moved_ = camera_moved(before_.image, after_.image);
  demonstration_.continue_waiting();
  if (!is_given(goal_.before))
    take_before(image_of(demonstration_.before(), after_.header.frame_id));
  wait_for_change();
}

void LessonImages::watch(const std::function<Step(const ImageFeed::State&)>& next_step) {
  for (int check = 0;; ++check) {
    const ImageFeed::State state = feed_.state();
    if (const auto why = feedback_.interruption()) fail_waiting(*why, state);
    const bool message_due = check % kChecksPerMessage == 0;
    if (state.any_image && state.silence > kSilentCamera) {
      if (message_due) report_missing_images(state);
    } else if (state.any_image) {
      const Step step = next_step(state);
      if (step == Step::kReady) return;
      if (message_due) report_step(step);
    } else if (message_due) {
      feedback_.tell(Feedback::WAIT_IMAGE, 0, "Waiting for an image from the camera.");
    }
    std::this_thread::sleep_for(kPollInterval);
  }
}

void LessonImages::report_missing_images(const ImageFeed::State& state) {
  feedback_.ask(Feedback::WAIT_IMAGE, 0,
                "The camera has sent no image for " +
                    std::to_string(static_cast<int>(state.silence)) +
                    " s: check its cable and driver. The lesson continues with the next image.");
}

void LessonImages::report_step(Step step) {
  switch (step) {
    case Step::kWaitStill:
      return feedback_.ask(Feedback::WAIT_IMAGE, 0.02,
                           "Something is moving in the image. Move arms and hands out of view "
                           "and keep still.");
    case Step::kMoving:
      return feedback_.ask(Feedback::WAIT_STILL, 0.2,
                           "Something is moving. Move out of view and keep still.");
    case Step::kAtBorder:
      return feedback_.ask(Feedback::WAIT_STILL, 0.2,
                           camera_moved_
                               ? kCameraMovedSinceGiven
                               : "Something reaches into the image from its edge: move it out.");
    default:
      return feedback_.ask(
          Feedback::WAIT_REMOVAL, 0.1,
          camera_moved_ ? kCameraMoved : removal_sentence(demonstration_.restart_reason()));
  }
}

void LessonImages::fail_waiting(LearnError interruption, const ImageFeed::State& state) const {
  if (interruption != LearnError::kTimeout) end_lesson(interruption);
  if (!state.any_image)
    end_lesson(LearnError::kNoImage,
               state.fault.empty() ? "" : "No usable image arrived: " + state.fault + ".");
  const LearnError error = state.silence > kSilentCamera ? LearnError::kNoImage
                           : state.still                 ? LearnError::kTimeout
                                                         : LearnError::kNotStill;
  const std::string& request = feedback_.last_request();
  if (request.empty()) end_lesson(error);
  end_lesson(error, std::string(message_of(error)) + " Last message: " + request,
             "Follow the last message, then teach again.");
}

}  // namespace mbncc::nodelets
