// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/lesson_region.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/change/changed_places.hpp"
#include "learning/change/departures.hpp"
#include "learning/teaching/click_region.hpp"
#include "learning/teaching/lesson_checks.hpp"
#include "learning/teaching/lesson_progress.hpp"
#include "mbncc/learning/change.hpp"

namespace mbncc::teaching {
namespace {

// Without a given place, the object is at the patch with the largest evidence of a departure,
// because a gripper may have changed a larger area.
void find_departure(const Lesson& lesson, ChangeSurvey& survey, RegionOfLesson& region) {
  const bool changed = cv::countNonZero(survey.changed) > 0;
  const cv::Mat left = change::departures(lesson.before, lesson.after, survey.changed);
  survey.changed = cv::Mat(left > 0);  // the one surveyed is kept
  const std::vector<cv::Rect> places = change::changed_places(left, survey.noisy);
  if (changed && places.empty())
    throw LessonEnded(LearnError::kNoChange, "Something was put down, but nothing was taken away.");
  region.room = places.empty() ? cv::Rect() : places.front();
  if (places.size() < 2) return;
  const double first = cv::sum(left(places[0]))[0];
  left(places[0]).setTo(0);  // the boxes have margins, which may overlap
  region.second_departure = std::min(1.0, cv::sum(left(places[1]))[0] / first);
}

// A region that is far larger than the change inside it is reduced to save time.
cv::Rect region_of_change(const Lesson& lesson, const ChangeSurvey& survey, const cv::Rect& room) {
  constexpr int kFarLarger = 4;
  if (lesson.click) return room;
  const cv::Rect narrow = change::changed_region(survey, room, 0.1);
  return !narrow.empty() && room.area() > kFarLarger * narrow.area() ? narrow : room;
}

// Whether the operator shows where the object was, closer than the change does. The verdict then
// tells whether the images were good enough.
bool shows_place(const Lesson& lesson) {
  constexpr double kPlacePart = 0.25;  // of the image
  return lesson.click || !lesson.outline.empty() ||
         (lesson.region != cv::Rect() &&
          usable_region(lesson).area() < kPlacePart * static_cast<double>(lesson.before.total()));
}

void survey(const Lesson& lesson, const LearningConfig& config, RegionOfLesson& region) {
  ChangeSurvey survey = survey_change(lesson.before, lesson.after);
  check_camera_still(survey, config);
  if (!shows_place(lesson)) check_one_change(survey, config);
  region.surveyed = survey.changed;
  if (is_without_place(lesson))
    find_departure(lesson, survey, region);
  else
    region.room = region_of_change(lesson, survey, region.room);
  region.changed = survey.changed;
}

// The change there; in one image without a region, what is cut alike in squares of many sizes.
void narrow_to_click(const Lesson& lesson, const LearningConfig& config, RegionOfLesson& region) {
  if (lesson.after.empty()) {
    if (lesson.region != cv::Rect()) return;
    const auto clicked = stable_region(lesson.before, *lesson.click, config.iterations);
    if (!clicked) refuse_click();
    region.approximate = clicked->map;
    region.room = clicked->square;
    region.agreement = clicked->agreement;
    return;
  }
  region.approximate = change_at_click(region.approximate, *lesson.click);
  ChangeSurvey clicked;
  clicked.changed = region.approximate;
  const cv::Rect room = change::changed_region(clicked, {{0, 0}, lesson.before.size()}, 0);
  if (!room.empty()) region.room = room;
}

void approximate(const Lesson& lesson, const LearningConfig& config, RegionOfLesson& region) {
  region.approximate = cv::Mat::zeros(lesson.before.size(), CV_8UC1);
  region.approximate(region.room).setTo(255);
  if (!region.changed.empty()) region.approximate &= region.changed;
  if (lesson.click) narrow_to_click(lesson, config, region);
  if (cv::countNonZero(region.approximate) == 0) throw LessonEnded(LearnError::kNoChange);
}

// One image tells the object from the background beside the region.
void check_background(const Lesson& lesson, const cv::Rect& room) {
  if (!lesson.after.empty() || !lesson.outline.empty() || lesson.region == cv::Rect()) return;
  if (room.size() == lesson.before.size())
    throw LessonEnded(LearnError::kRegionInvalid, "The region is the whole image.",
                      "Draw it close around the object.");
}

}  // namespace

bool is_without_place(const Lesson& lesson) {
  return lesson.region == cv::Rect() && !lesson.click;
}

RegionOfLesson region_of(const Lesson& lesson, const LearningConfig& config) {
  RegionOfLesson region;
  region.room = usable_region(lesson);
  check_background(lesson, region.room);
  if (!lesson.after.empty()) survey(lesson, config, region);
  if (lesson.outline.empty()) {
    approximate(lesson, config, region);
  } else {
    region.approximate = outline_map(lesson);
    region.room = cv::boundingRect(region.approximate);
  }
  return region;
}

}  // namespace mbncc::teaching
