// SPDX-License-Identifier: BSD-3-Clause
// Provides the pictures of a lesson: given with the goal, or live.
#include <ros/time.h>

#include <chrono>
#include <thread>

#include "nodelets/conversion/images.hpp"
#include "nodelets/learning/camera_motion.hpp"
#include "nodelets/learning/lesson.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;

constexpr std::chrono::milliseconds kGlance{30};  // between two checks of the live scene
constexpr int kGlancesPerWord = 15;               // between two messages to the operator

constexpr double kSilentCamera = 2;  // [s] without a picture before the operator is informed

const char* const kCameraMoved =
    "The camera has moved; the lesson goes on with the present picture. Fasten the camera, see "
    "that "
    "the object lies in the picture, then take it away.";
const char* const kCameraMovedSinceGiven =
    "The camera has moved since the picture before was taken: put it back, or teach with a new "
    "one.";

const char* removal_sentence(Demonstration::Anew why) {
  using Anew = Demonstration::Anew;
  switch (why) {
    case Anew::kLight:
      return "The light has changed; the lesson continues with the current picture. Take the "
             "object "
             "away now.";
    case Anew::kEdgeLeft:
      return "The arm or hand at the picture's edge has left; the lesson continues with the "
             "current picture. If the object is gone as well, put it back fully into view; then "
             "take it away.";
    case Anew::kEverything:
      return "Nearly everything has changed, as when the camera is moved; the lesson continues "
             "with the current picture. Make sure that the object is in view, then take it away.";
    case Anew::kPutDown:
      return "No object has left its place; what was put down now belongs to the scene. Take the "
             "object farther away or out of the picture.";
    default:
      return "Take the object away now.";
  }
}

LessonPicture picture_of(const StillShot& shot, const std::string& frame_id) {
  LessonPicture picture{shot.picture, {}, shot.number};
  picture.header.stamp.fromSec(shot.stamp);
  picture.header.frame_id = frame_id;
  return picture;
}

}  // namespace

void LessonRun::take_pictures() {
  const bool change = goal_.mode == Goal::CHANGE;
  if (is_given(goal_.before)) {
    take_before(given(goal_.before, "before"));
    demonstration_ = Demonstration(before_.picture);
  }
  if (change && is_given(goal_.after)) after_ = given(goal_.after, "after");
  if (change && goal_.already_moved && before_.picture.empty()) return take_already_moved();
  if (before_.picture.empty()) wait_for_before();
  if (change && after_.picture.empty()) wait_for_change();
}

void LessonRun::take_before(const LessonPicture& picture) {
  before_ = picture;
  calibrate_before();
}

void LessonRun::calibrate_before() {
  calibration_ =
      tools_.gauge.calibrate_picture(goal_.camera_info, before_.header, before_.picture.size());
}

bool LessonRun::waits_for_change() const {
  return goal_.mode == Goal::CHANGE && !is_given(goal_.after) && !goal_.already_moved;
}

LessonPicture LessonRun::given(const sensor_msgs::Image& image, const std::string& what) const {
  const Decoded decoded = decode_picture(image, tools_.pictures.white_level());
  if (!decoded) fail(LearnError::kEncoding, "Picture " + what + ": " + decoded.fault + ".");
  return {decoded.picture, image.header, 0};
}

void LessonRun::take_already_moved() {
  if (after_.picture.empty())
    watch([this](const PictureFeed::View& view) {
      if (!view.still) return Step::kWaitStill;
      after_ = picture_of(*view.still, view.header.frame_id);
      return Step::kReady;
    });
  const auto before = tools_.pictures.before_change();
  if (!before)
    fail(LearnError::kNoChange, "Nothing in the camera's view has changed recently.",
         "Teach without already_moved, and take the object away when asked.");
  take_before(picture_of(*before, after_.header.frame_id));
}

void LessonRun::wait_for_before() {
  watch([this](const PictureFeed::View& view) {
    if (demonstration_.look(view.still) == Step::kWaitStill) return Step::kWaitStill;
    take_before(picture_of(demonstration_.before(), view.header.frame_id));
    return Step::kReady;
  });
}

void LessonRun::wait_for_change() {
  watch([this](const PictureFeed::View& view) {
    if (view.still && view.still->picture.size() != before_.picture.size())
      fail(LearnError::kImageMismatch);
    const Step step = demonstrate(view.still);
    if (demonstration_.before().picture.data != before_.picture.data)
      take_before(picture_of(demonstration_.before(), view.header.frame_id));
    if (step == Step::kReady) after_ = picture_of(demonstration_.after(), view.header.frame_id);
    return step;
  });
}

/// A moved camera makes the picture before useless, as what has come over the edge does not.
Demonstration::Step LessonRun::demonstrate(const std::optional<StillShot>& still) {
  const cv::Mat was = demonstration_.before().picture;
  const Step step = demonstration_.look(still);
  const cv::Mat is = demonstration_.before().picture;
  if (is.data != was.data) camera_moved_ = camera_moved(was, is);
  if (step != Step::kAtBorder || still->stamp == followed_at_) return step;
  followed_at_ = still->stamp;
  camera_moved_ = camera_moved(is, still->picture);
  if (!camera_moved_ || is_given(goal_.before)) return step;
  demonstration_ = Demonstration();
  demonstration_.look(still);
  return Step::kWaitRemoval;
}

void LessonRun::wait_on() {
  camera_moved_ = camera_moved(before_.picture, after_.picture);
  demonstration_.go_on();
  if (!is_given(goal_.before))
    take_before(picture_of(demonstration_.before(), after_.header.frame_id));
  wait_for_change();
}

void LessonRun::watch(const std::function<Step(const PictureFeed::View&)>& look) {
  for (int glance = 0;; ++glance) {
    const PictureFeed::View view = tools_.pictures.look();
    if (const auto why = client_.interruption()) fail_waiting(*why, view);
    const bool word_due = glance % kGlancesPerWord == 0;
    if (view.any_picture && view.silence > kSilentCamera) {
      if (word_due) say_silence(view);
    } else if (view.any_picture) {
      const Step step = look(view);
      if (step == Step::kReady) return;
      if (word_due) say(step);
    } else if (word_due) {
      tell(Feedback::WAIT_IMAGE, 0, "Waiting for a picture from the camera.");
    }
    std::this_thread::sleep_for(kGlance);
  }
}

void LessonRun::ask_operator_to(std::uint8_t stage, double progress, const std::string& sentence) {
  asked_for_ = sentence;
  tell(stage, progress, sentence, true);
}

void LessonRun::say_silence(const PictureFeed::View& view) {
  ask_operator_to(
      Feedback::WAIT_IMAGE, 0,
      "The camera has sent no picture for " + std::to_string(static_cast<int>(view.silence)) +
          " s: check its cable and driver. The lesson continues with the next picture.");
}

void LessonRun::say(Step step) {
  switch (step) {
    case Step::kWaitStill:
      return ask_operator_to(Feedback::WAIT_IMAGE, 0.02,
                             "The scene moves: move arm and hands out and keep still.");
    case Step::kMoving:
      return ask_operator_to(Feedback::WAIT_STILL, 0.2,
                             "Something moves: leave the picture and keep still.");
    case Step::kAtBorder:
      return ask_operator_to(
          Feedback::WAIT_STILL, 0.2,
          camera_moved_
              ? kCameraMovedSinceGiven
              : "Something has come that reaches into the picture over its edge: move it out.");
    default:
      return ask_operator_to(
          Feedback::WAIT_REMOVAL, 0.1,
          camera_moved_ ? kCameraMoved : removal_sentence(demonstration_.anew()));
  }
}

void LessonRun::fail_waiting(LearnError interruption, const PictureFeed::View& view) const {
  if (interruption != LearnError::kTimeout) fail(interruption);
  if (!view.any_picture)
    fail(LearnError::kNoImage,
         view.fault.empty() ? "" : "No usable picture arrived: " + view.fault + ".");
  const LearnError error = view.silence > kSilentCamera ? LearnError::kNoImage
                           : view.still                 ? LearnError::kTimeout
                                                        : LearnError::kNotStill;
  if (asked_for_.empty()) fail(error);
  fail(error, std::string(message_of(error)) + " Last message: " + asked_for_,
       "Follow the last message, then teach again.");
}

}  // namespace mbncc::nodelets
