// SPDX-License-Identifier: BSD-3-Clause
#include "cell/demo.hpp"

#include "mbncc/cell/part_put_down.hpp"

namespace mbncc::bench {
namespace {

bool has_left(const Outcome& outcome, const Demonstration& demonstration) {
  const LearnResult& learned = outcome.learned;
  return !learned.has_model ||
         part_put_down(full_size_map(learned.object.views.front()), demonstration.before().image,
                       demonstration.after().image) < kMostPutDown;
}

Outcome timed_out() {
  Outcome late;
  late.timed_out = true;
  return late;
}

}  // namespace

Outcome Demo::run() {
  if (way_ == Way::kAlreadyMoved) return already_moved();
  if (way_ == Way::kPutDownFirst) {
    cell_.script().take_away();
    cell_.finish_motion();
  }
  cell_.rest(random_.uniform(0, 12));
  Demonstration demonstration;
  for (int i = 0; i < kPatience; ++i) {
    const auto step = demonstration.update(cell_.watch.still());
    if (step == Demonstration::Step::kReady) {
      Outcome outcome = learn(demonstration.before().image, demonstration.after().image);
      if (outcome.learned.error != LearnError::kNoChange && has_left(outcome, demonstration))
        return outcome;
      demonstration.continue_waiting();
    } else if (step == Demonstration::Step::kWaitRemoval) {
      act();
    }
    cell_.show();
  }
  return timed_out();
}

/// The operator's reaction to the request to take the object away, after some hesitation.
void Demo::act() {
  if (!cell_.script().at_rest() || hesitation_-- > 0) return;
  hesitation_ = 25;
  if (intrusions_-- > 0) return cell_.reach_in();
  const bool lies = cell_.script().place().has_value();
  if (!lies) {
    cell_.script().put_next();
    return;
  }
  shown_ = *cell_.script().place();
  way_ == Way::kPutAside ? cell_.script().put_next() : cell_.script().take_away();
}

Outcome Demo::already_moved() {
  cell_.rest(random_.uniform(12, 25));
  if (intrusions_ > 0) cell_.reach_in();
  cell_.rest(12);
  shown_ = *cell_.script().place();
  cell_.script().take_away();
  cell_.finish_motion();
  cell_.rest(12);
  const auto after = cell_.watch.still(), before = cell_.watch.before_change();
  if (!after || !before) return timed_out();
  return learn(before->image, after->image);
}

Outcome Demo::learn(const cv::Mat& before, const cv::Mat& after) const {
  Lesson lesson;
  lesson.name = "part";
  lesson.before = before;
  lesson.after = after;
  return {learn_object(lesson), shown_, false};
}

}  // namespace mbncc::bench
