#include "learning/lesson_region.hpp"

#include <opencv2/imgproc.hpp>

#include "learning/arrival_test.hpp"
#include "learning/click_region.hpp"
#include "learning/lesson_checks.hpp"
#include "learning/lesson_progress.hpp"
#include "mbncc/learning/change.hpp"

namespace mbncc {
namespace {

// What changed without the object's having been taken away from there is none of it.
void drop_arrivals(const Lesson& lesson, ChangeSurvey& survey) {
  const bool changed = cv::countNonZero(survey.changed) > 0;
  survey.changed = without_arrivals(lesson.before, lesson.after, survey.changed);
  if (changed && cv::countNonZero(survey.changed) == 0)
    throw LessonEnded(LearnError::kNoChange, "Something was put down, but nothing was taken away.");
}

// Without a region, the largest change is the object. A region that is far larger than all change
// inside it is narrowed: the work grows with it.
cv::Rect region_of_change(const Lesson& lesson, const ChangeSurvey& survey, const cv::Rect& room) {
  constexpr int kFarLarger = 4;
  if (lesson.click) return room;
  if (lesson.region == cv::Rect()) return changed_region(survey, room, 1);
  const cv::Rect narrow = changed_region(survey, room, 0.1);
  return !narrow.empty() && room.area() > kFarLarger * narrow.area() ? narrow : room;
}

void survey(const Lesson& lesson, const LearningConfig& config, RegionOfLesson& region) {
  ChangeSurvey survey = survey_change(lesson.before, lesson.after);
  check_survey(survey, config);
  region.surveyed = survey.changed;
  // Where nobody says which change is meant, it is the one that something left.
  if (is_without_place(lesson)) drop_arrivals(lesson, survey);
  region.changed = survey.changed;
  region.room = region_of_change(lesson, survey, region.room);
}

// The change there, or else what has the colour there.
void narrow_to_click(const Lesson& lesson, RegionOfLesson& region) {
  region.approximate = lesson.after.empty() ? grow_from_click(lesson.before, *lesson.click)
                                            : change_at_click(region.approximate, *lesson.click);
  ChangeSurvey clicked;
  clicked.changed = region.approximate;
  const cv::Rect room = changed_region(clicked, {{0, 0}, lesson.before.size()}, 0);
  if (!room.empty()) region.room = room;
}

void approximate(const Lesson& lesson, RegionOfLesson& region) {
  region.approximate = cv::Mat::zeros(lesson.before.size(), CV_8UC1);
  region.approximate(region.room).setTo(255);
  if (!region.changed.empty()) region.approximate &= region.changed;
  if (lesson.click) narrow_to_click(lesson, region);
  if (cv::countNonZero(region.approximate) == 0) throw LessonEnded(LearnError::kNoChange);
}

}  // namespace

bool is_without_place(const Lesson& lesson) {
  return lesson.region == cv::Rect() && !lesson.click;
}

RegionOfLesson region_of(const Lesson& lesson, const LearningConfig& config) {
  RegionOfLesson region;
  region.room = usable_region(lesson);
  if (!lesson.after.empty()) survey(lesson, config, region);
  if (lesson.outline.empty()) {
    approximate(lesson, region);
  } else {
    region.approximate = outline_map(lesson);
    region.room = cv::boundingRect(region.approximate);
  }
  return region;
}

}  // namespace mbncc
