// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/lesson_checks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <string>

#include "learning/teaching/lesson_progress.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::teaching {
namespace {

constexpr int kSmallestImage = 32;      // [px]
constexpr int kSmallestRegion = 8;      // [px]
constexpr int kLargestImage = 1 << 15;  // [px] largest side of an image
constexpr double kFullPart = 0.98;      // of the room, from which on a map is everything
constexpr double kDisplaced = 0.6;      // part of the texture that only a moved camera displaces

void require(bool condition, LearnError error, const std::string& message,
             const std::string& hint = "") {
  if (!condition) throw LessonEnded(error, message, hint);
}

std::string size_text(const cv::Size& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

void check_image(const cv::Mat& image, const std::string& which) {
  require(!image.empty() && image.dims == 2, LearnError::kNoImage,
          "The image " + which + " is missing.");
  require(image.type() == CV_8UC3, LearnError::kNoImage,
          "The image " + which + " is not an 8-bit colour image.");
  require(image.rows >= kSmallestImage && image.cols >= kSmallestImage, LearnError::kNoImage,
          "The image " + which + " is only " + size_text(image.size()) + " pixels.");
  require(image.rows <= kLargestImage && image.cols <= kLargestImage, LearnError::kNoImage,
          "The image " + which + " is too large: " + size_text(image.size()) + " pixels.");
}

void check_same_size(const cv::Mat& image, const cv::Mat& before, const std::string& which) {
  require(image.size() == before.size(), LearnError::kImageMismatch,
          "The " + which + " has " + size_text(image.size()) + " pixels, the image before " +
              size_text(before.size()) + ".");
}

bool is_finite(const Pose2D& pose) {
  return std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.theta);
}

bool is_near(const Pose2D& reference) {
  return std::max(std::abs(reference.x), std::abs(reference.y)) <= kFarthestReference;
}

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

}  // namespace

void check_lesson(const Lesson& lesson) {
  if (!is_valid_name(lesson.name)) throw LessonEnded(LearnError::kNameInvalid);
  check_image(lesson.before, "before");
  if (!lesson.after.empty()) {
    check_image(lesson.after, "after");
    check_same_size(lesson.after, lesson.before, "image after");
  }
  if (!lesson.map.empty()) {
    check_same_size(lesson.map, lesson.before, "map");
    require(lesson.map.type() == CV_8UC1, LearnError::kImageMismatch,
            "The map is not an 8-bit grey image.");
  }
  require(!lesson.reference || is_finite(*lesson.reference), LearnError::kRegionInvalid,
          "The reference point is not a number.");
  require(!lesson.reference || is_near(*lesson.reference), LearnError::kRegionInvalid,
          "The reference point lies more than 131072 pixels off.");
  require(lesson.object_height >= 0 && lesson.object_height <= kLongestLength,
          LearnError::kRegionInvalid, "The object's height must be 0 to 10 metres.");
  require(!lesson.symmetry || is_declarable_symmetry(*lesson.symmetry), LearnError::kRegionInvalid,
          "The declared symmetry must be 1 (none), 2, 3, 4, 6 or 0 (round).");
  require(
      !lesson.click || cv::Rect2d({0, 0}, cv::Size2d(lesson.before.size())).contains(*lesson.click),
      LearnError::kRegionInvalid, "The click does not lie in the image.",
      point_inside(lesson.before.size()));
  require(
      !lesson.map.empty() || !lesson.outline.empty() || lesson.click || !lesson.after.empty() ||
          lesson.region != cv::Rect(),
      LearnError::kRegionInvalid,
      "The object's place is not given: there is no map, outline, click, region or image after.");
}

std::string point_inside(const cv::Size& image) {
  return "Give a point inside the image of " + size_text(image) + " px.";
}

bool is_near_image(const cv::Point2d& point) {
  return std::abs(point.x) <= kLargestImage && std::abs(point.y) <= kLargestImage;
}

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
      LearnError::kRegionInvalid, "");
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

void check_given_map(const cv::Mat& map) {
  const int filled = cv::countNonZero(map);
  require(filled > 0, LearnError::kSegmentationEmpty, "The map is black everywhere.",
          "Paint the object white.");
  require(filled < kFullPart * static_cast<double>(map.total()), LearnError::kSegmentationFull,
          "The map is white nearly everywhere.", "Paint everything but the object black.");
}

void refuse_click() {
  throw LessonEnded(LearnError::kSegmentationEmpty, "No object stands out at the click.",
                    "Click on the object itself, or draw a region (roi) around it.");
}

void check_map(const cv::Mat& map, const cv::Rect& room) {
  const int filled = cv::countNonZero(map);
  if (filled == 0) throw LessonEnded(LearnError::kSegmentationEmpty);
  if (filled >= kFullPart * room.area()) throw LessonEnded(LearnError::kSegmentationFull);
}

}  // namespace mbncc::teaching
