// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/learning/lesson_store.hpp"

#include <cstdio>
#include <utility>

#include "mbncc/learning/further_view.hpp"
#include "nodelets/learning/lesson_feedback.hpp"
#include "nodelets/learning/lesson_goal.hpp"
#include "nodelets/learning/outcome.hpp"

namespace mbncc::nodelets {
namespace {

/// Sentence about where the object was put aside; "" if it was not found again.
std::string put_aside_sentence(const LearnResult& learned) {
  const auto& seen = learned.put_aside;
  if (!seen) return "";
  const double turn = seen->pose.theta - learned.object.views.back().reference.theta;
  char text[160];
  std::snprintf(text, sizeof text,
                " Found again where it was put aside: x %.1f, y %.1f, rotated by %.1f degrees; "
                "the views agree to %.2f%s.",
                seen->pose.x, seen->pose.y, to_degrees(wrap_angle(turn)), seen->agreement,
                seen->refined ? " and both contribute to the map" : "");
  return text;
}

}  // namespace

LessonStore::LessonStore(const mbncc_vision::LearnObjectGoal& goal, std::string name,
                         const LessonTools& tools, const LessonImages& images)
    : goal_(goal),
      name_(std::move(name)),
      tools_(tools),
      images_(images),
      started_(ros::Time::now()) {}

mbncc_vision::LearnObjectResult LessonStore::store(const LearnResult& learned,
                                                   const Calibration& calibration) {
  ObjectModel model = learned.object;
  model.learned_at = ros::Time::now().toSec();
  model.taught_by = tools_.cell_name;
  try {
    std::string lacking;
    const ObjectModel stored = save(model, calibration, lacking);
    const std::string message =
        "Learned '" + name_ + "', verdict " + to_string(stored.quality.verdict) + ".";
    return with_object(
        outcome(LearnError::kSuccess, message + put_aside_sentence(learned) + lacking), stored,
        images_.before());
  } catch (const std::exception& failure) {
    return with_object(outcome(Refusal(failure)), model, images_.before());
  }
}

ObjectModel LessonStore::save(ObjectModel model, const Calibration& calibration,
                              std::string& lacking) {
  using Existing = ObjectLibrary::Existing;
  const Storing storing = storing_of(goal_);
  return tools_.library.change([&](ObjectLibrary& library) {
    if (storing == Storing::kAddView)
      return attempts_.add_view(library, name_, [&](ObjectModel& stored) {
        if (const auto refusal = add_view(stored, model, images_.before().image, tools_.search))
          end_lesson(outcome(*refusal));
        lacking = measure(stored, calibration);
      });
    lacking = measure(model, calibration);
    return attempts_.save(library, model,
                          storing == Storing::kReplace ? Existing::kReplace : Existing::kRefuse);
  });
}

/// Adds scale and grasp to the model, measured in its newest view, which is that of this lesson. An
/// object that gets a further view keeps its scale. Returns a message about missing data.
std::string LessonStore::measure(ObjectModel& model, const Calibration& calibration) const {
  const bool live = images_.before().number > 0;
  const LessonMeasures measures =
      tools_.gauge.measure(calibration, live ? images_.before().header.stamp : started_,
                           model.views.back().reference, model.object_height);
  if (!goal_.add_view) model.metres_per_pixel = measures.metres_per_pixel;
  if (measures.grasp) model.grasp = measures.grasp;
  return missing_data_message(measures);
}

std::string LessonStore::missing_data_message(const LessonMeasures& measures) const {
  const std::string earlier = measures.marked_earlier
                                  ? " The marked grasp was not stored: it was marked before this "
                                    "demonstration began; mark it during the next one."
                                  : "";
  if (measures.fault.empty() || (goal_.add_view && !measures.marked)) return earlier;
  const std::string what = goal_.add_view    ? "The marked grasp was not stored"
                           : measures.marked ? "Learned without scale and marked grasp"
                                             : "Learned without scale";
  return " " + what + ": " + measures.fault + "." + earlier;
}

}  // namespace mbncc::nodelets
