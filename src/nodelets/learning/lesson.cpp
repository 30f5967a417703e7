// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson.hpp"

#include <ros/time.h>

#include <cstdio>
#include <opencv2/imgproc.hpp>

#include "mbncc/cell/second_look.hpp"
#include "mbncc/drawing.hpp"
#include "mbncc/learning/resemblance.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/messages.hpp"
#include "nodelets/learning/lesson_goal.hpp"
#include "nodelets/learning/lesson_stages.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {
namespace {

using Feedback = mbncc_vision::LearnObjectFeedback;

std::uint8_t feedback_stage(Stage stage) {
  if (stage == Stage::kRegion) return Feedback::REGION;
  return stage == Stage::kSegment ? Feedback::SEGMENT : Feedback::QUALITY;
}

// Box around the map in the learning image. [px]
cv::Rect place_of(const View& view) {
  return cv::boundingRect(view.map) + view.origin;
}

}  // namespace

LessonRun::LessonRun(LessonClient& client, const LessonTools& tools)
    : client_(client),
      tools_(tools),
      goal_(client.goal()),
      name_(name_for(goal_, *tools.library.snapshot())),
      started_(ros::Time::now()) {}

LessonRun::Result LessonRun::run() {
  try {
    return teach_and_store();
  } catch (const LessonEnded& ended) {
    return ended.result;
  }
}

LessonRun::Result LessonRun::teach_and_store() {
  take_images();
  learn();
  // No object has left: the coarse comparison was wrong, or something was put down, which belongs
  // to the scene before from now on.
  while ((learned_.error == LearnError::kNoChange || lies_there_yet()) && waits_for_change()) {
    wait_on();
    learn();
  }
  if (lies_there_yet())
    fail(LearnError::kNoChange, "The object was put down where it covers its old place.",
         "Put it farther away, or take it out of the image.");
  if (goal_.confirm && learned_.has_model) return review();
  judge();
  return store();
}

Lesson LessonRun::lesson_of(const cv::Mat& after) const {
  GoalLesson made = to_lesson(goal_, name_, before_.image, after);
  if (made.fault) throw LessonEnded{*made.fault};
  return made.lesson;
}

/// The map then contains the old place and the new one.
bool LessonRun::lies_there_yet() const {
  if (!learned_.has_model || goal_.mode != Goal::CHANGE) return false;
  const cv::Mat map = full_size_map(learned_.object.views.front());
  return part_put_down(map, before_.image, after_.image) >= kMostPutDown;
}

void LessonRun::learn() {
  draft_.emplace(lesson_of(after_.image), tools_.config, tools_.search, observer());
  tools_.show_image(before_.image);
  take_draft();
}

StageObserver LessonRun::observer() {
  return [this](Stage stage, double progress, const std::string& message, const cv::Mat& image) {
    tell(feedback_stage(stage), kTaken + (kLearned - kTaken) * progress, message);
    if (!image.empty()) tools_.show_stage(image);
    return !client_.interruption();
  };
}

/// Updates the draft and compares it with the known objects.
void LessonRun::take_draft() {
  leave_if_interrupted();
  learned_ = draft_->result();
  if (!learned_.has_model) return;
  note_resemblance(learned_.object, before_.image, tools_.library.snapshot()->objects,
                   tools_.search);
  if (goal_.add_view) note_view();
  leave_if_interrupted();
  tools_.show_preview(preview(learned_.object));
  tools_.show_draft(
      describe(outcome(learned_.error, learned_.message, learned_.hint), learned_.object));
  tools_.show_score_map(learned_.object, before_.image);
}

void LessonRun::note_view() {
  if (const auto stored = tools_.library.snapshot()->find(name_))
    note_refused_view(learned_.object, *stored, before_.image, tools_.search);
}

void LessonRun::judge() const {
  if (may_be_stored()) return;
  const Result failed = outcome(learned_.error, learned_.message, learned_.hint);
  throw LessonEnded{learned_.has_model ? describe(failed, learned_.object) : failed};
}

bool LessonRun::may_be_stored() const {
  return learned_.error == LearnError::kSuccess || (learned_.has_model && goal_.allow_bad);
}

LessonRun::Result LessonRun::store() {
  leave_if_interrupted();
  tell(Feedback::STORE, kChecked, "Storing '" + name_ + "'.");
  ObjectModel model = learned_.object;
  model.learned_at = ros::Time::now().toSec();
  model.taught_by = tools_.cell_name;
  // tf or camera_info may have arrived slightly later than the image.
  if (!calibration_.platform) calibrate_before();
  try {
    std::string lacking;
    const ObjectModel stored = save(model, lacking);
    std::string message =
        "Learned '" + name_ + "', verdict " + to_string(stored.quality.verdict) + ".";
    return describe(outcome(LearnError::kSuccess, message + second_view() + lacking), stored);
  } catch (const std::exception& failure) {
    return describe(outcome(Refusal(failure)), model);
  }
}

/// Message with the place where the object was put aside; "" if it was not found again.
std::string LessonRun::second_view() const {
  const auto& seen = learned_.put_aside;
  if (!seen) return "";
  const double turn = seen->pose.theta - learned_.object.views.back().reference.theta;
  char text[160];
  std::snprintf(text, sizeof text,
                " Found again where it was put aside: x %.1f, y %.1f, rotated by %.1f degrees; "
                "both views agree by %.2f%s.",
                seen->pose.x, seen->pose.y, to_degrees(wrap_angle(turn)), seen->agreement,
                seen->refined ? " and both contribute to the map" : "");
  return text;
}

/// Uses the model's newest view, the one of this lesson; a known object keeps its scale. Returns a
/// message about missing data.
std::string LessonRun::measure(ObjectModel& model) const {
  const bool live = before_.number > 0;
  const LessonMeasures measures =
      tools_.gauge.measure(calibration_, live ? before_.header.stamp : started_,
                           model.views.back().reference, model.object_height);
  if (!goal_.add_view) model.metres_per_pixel = measures.metres_per_pixel;
  if (measures.grasp) model.grasp = measures.grasp;
  return lack(measures);
}

std::string LessonRun::lack(const LessonMeasures& measures) const {
  if (measures.fault.empty() || (goal_.add_view && !measures.marked)) return "";
  const std::string what = goal_.add_view    ? "The marked grasp was not stored"
                           : measures.marked ? "Learned without scale and marked grasp"
                                             : "Learned without scale";
  return " " + what + ": " + measures.fault + ".";
}

ObjectModel LessonRun::save(ObjectModel model, std::string& lacking) const {
  using Existing = ObjectLibrary::Existing;
  const Storing storing = storing_of(goal_);
  return tools_.library.change([&](ObjectLibrary& library) {
    if (storing == Storing::kAddView)
      return library.edit(name_, [&](ObjectModel& stored) {
        if (const auto refusal = add_view(stored, model, before_.image, tools_.search))
          throw LessonEnded{outcome(*refusal)};
        lacking = measure(stored);
      });
    lacking = measure(model);
    return library.save(model,
                        storing == Storing::kReplace ? Existing::kReplace : Existing::kRefuse);
  });
}

LessonRun::Result LessonRun::describe(Result result, const ObjectModel& model) const {
  const View& view = model.views.back();
  result.object = to_msg(model, true);
  result.map = encode_image(view.map);
  result.template_image = encode_image(view.template_image);
  result.preview = encode_image(preview(model), before_.header);
  return result;
}

cv::Mat LessonRun::preview(const ObjectModel& model) const {
  const std::string caption = model.name + " " + to_string(model.quality.verdict);
  return draw_markings(before_.image, {marking_of(model.views.back(), model.quality, caption)});
}

void LessonRun::tell(std::uint8_t stage, double progress, const std::string& message,
                     bool operator_action) {
  Feedback feedback;
  feedback.stage = stage;
  feedback.progress = static_cast<float>(progress);
  feedback.message = message;
  feedback.operator_action = operator_action;
  feedback.roi = learned_.has_model ? to_msg(place_of(learned_.object.views.front())) : goal_.roi;
  client_.tell(feedback);
}

void LessonRun::fail(LearnError error, const std::string& message, const std::string& hint) const {
  throw LessonEnded{outcome(error, message, hint)};
}

void LessonRun::leave_if_interrupted() const {
  if (const auto why = client_.interruption()) fail(*why);
}

}  // namespace mbncc::nodelets
