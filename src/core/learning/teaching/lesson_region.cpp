// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/lesson_region.hpp"

#include <algorithm>
#include <cstdint>
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

constexpr int kSmallestRegion = 8;  // [px]
constexpr double kDisplaced = 0.6;  // part of the texture that only a moved camera displaces

double cross(const cv::Point2d& a, const cv::Point2d& b) {
  return a.x * b.y - a.y * b.x;
}

bool segments_cross(const cv::Point2d& a, const cv::Point2d& b, const cv::Point2d& c,
                    const cv::Point2d& d) {
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 &&
         cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

bool crosses_itself(const std::vector<cv::Point2f>& outline) {
  const std::size_t n = outline.size();
  const auto corner = [&](std::size_t i) { return cv::Point2d(outline[i % n]); };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (segments_cross(corner(i), corner(i + 1), corner(j), corner(j + 1))) return true;
  return false;
}

// Without a given place, the object is at the patch with the largest evidence of a departure,
// because a gripper may have changed a larger area.
void find_departure(const Lesson& lesson, ChangeSurvey& survey, RegionOfLesson& region) {
  const bool changed = cv::countNonZero(survey.changed) > 0;
  const cv::Mat left = change::departures(lesson.before, lesson.after, survey.changed);
  survey.changed = cv::Mat(left > 0);  // a new image: `surveyed` shares the old one
  const std::vector<cv::Rect> places = change::changed_places(left, survey.noisy);
  if (changed && places.empty())
    throw LessonEnded(LearnError::kNoChange, "Something was put down, but nothing was taken away.",
                      "Take the object away; if the images are in the wrong order, exchange before "
                      "and after.");
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

// Whether the operator's input shows the object's place more precisely than the change does. The
// verdict then tells whether the images were good enough.
bool shows_place(const Lesson& lesson) {
  constexpr double kPlacePart = 0.5;  // of the image
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

// Narrows the region to the change at the click or, in one image without a region, to what is cut
// alike in squares of many sizes.
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
  if (cv::countNonZero(region.approximate) > 0) return;
  if (lesson.click || lesson.region == cv::Rect()) throw LessonEnded(LearnError::kNoChange);
  throw LessonEnded(LearnError::kNoChange,
                    "The images before and after show no difference in the region.",
                    "Draw the region around the place where the object lay.");
}

// With one image, the background's colours are those outside the region, so the region must not be
// the whole image.
void check_background(const Lesson& lesson, const cv::Rect& room) {
  if (!lesson.after.empty() || !lesson.outline.empty() || lesson.region == cv::Rect()) return;
  if (room.size() == lesson.before.size())
    throw LessonEnded(LearnError::kRegionInvalid, "The region is the whole image.",
                      "Draw it close around the object.");
}

}  // namespace

cv::Rect usable_region(const Lesson& lesson) {
  const cv::Rect& given = lesson.region;
  if (given == cv::Rect()) return {{0, 0}, lesson.before.size()};
  const int shorter = std::min(given.width, given.height);
  require(shorter <= 0 || shorter >= kSmallestRegion, LearnError::kRegionInvalid,
          "The region is only " + size_text(given.size()) + " px.", "Give at least 8 x 8 px.");
  // Very large numbers would overflow cv::Rect.
  const auto clipped = [](int start, int length, int limit) {
    const std::int64_t low = std::max<std::int64_t>(start, 0);
    const std::int64_t high = std::min<std::int64_t>(std::int64_t{start} + length, limit);
    return cv::Range(static_cast<int>(std::min<std::int64_t>(low, limit)), static_cast<int>(high));
  };
  const cv::Range columns = clipped(given.x, given.width, lesson.before.cols);
  const cv::Range rows = clipped(given.y, given.height, lesson.before.rows);
  require(
      columns.end - columns.start >= kSmallestRegion && rows.end - rows.start >= kSmallestRegion,
      LearnError::kRegionInvalid, "The region does not lie in the image.",
      "Give a region inside the image of " + size_text(lesson.before.size()) + " px.");
  return {columns.start, rows.start, columns.end - columns.start, rows.end - rows.start};
}

cv::Mat outline_map(const Lesson& lesson) {
  constexpr int kFractionBits = 4;
  require(lesson.outline.size() >= 3, LearnError::kRegionInvalid,
          "The outline has fewer than three corners.");
  require(lesson.outline.size() <= kMostPoints, LearnError::kRegionInvalid,
          "The outline has more than 4096 corners.");
  std::vector<cv::Point> corners;
  for (const auto& corner : lesson.outline) {
    require(is_near_image(corner), LearnError::kRegionInvalid,
            "The outline does not lie in the image.");
    corners.emplace_back(cvRound(corner.x * (1 << kFractionBits)),
                         cvRound(corner.y * (1 << kFractionBits)));
  }
  require(!crosses_itself(lesson.outline), LearnError::kRegionInvalid,
          "The outline crosses itself.");
  cv::Mat map = cv::Mat::zeros(lesson.before.size(), CV_8UC1);
  cv::fillPoly(map, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255), cv::LINE_8,
               kFractionBits);
  require(cv::countNonZero(map) > 0, LearnError::kRegionInvalid,
          "The outline does not lie in the image.");
  return map;
}

void check_camera_still(const ChangeSurvey& survey, const LearningConfig& config) {
  constexpr LearnError kError = LearnError::kChangeTooLarge;
  require(cv::norm(survey.shift) <= config.max_shift, kError,
          "The camera moved between the images.");
  require(survey.displaced <= kDisplaced, kError,
          "The scene moved under the camera between the images.");
}

void check_one_change(const ChangeSurvey& survey, const LearningConfig& config) {
  constexpr LearnError kError = LearnError::kChangeTooLarge;
  require(survey.exposure <= config.max_exposure_change, kError,
          "The exposure or the light changed between the images.");
  require(survey.unevenness <= config.max_light_change, kError,
          "The light comes from another direction in the second image.");
  require(survey.fraction <= config.max_change, kError, "");
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
