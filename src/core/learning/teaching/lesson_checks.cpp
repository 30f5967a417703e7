// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/lesson_checks.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "learning/teaching/lesson_progress.hpp"
#include "mbncc/image_limits.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::teaching {
namespace {

constexpr int kSmallestImage = 32;  // [px]

void check_image(const cv::Mat& image, const std::string& which) {
  require(!image.empty() && image.dims == 2, LearnError::kNoImage,
          "The image " + which + " is missing.");
  require(image.type() == CV_8UC3, LearnError::kNoImage,
          "The image " + which + " is not an 8-bit colour image.");
  require(image.rows >= kSmallestImage && image.cols >= kSmallestImage, LearnError::kNoImage,
          "The image " + which + " is only " + size_text(image.size()) + " pixels.");
  require(ImageLimits::hold(image.size()), LearnError::kNoImage,
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
          "The declared symmetry must be 1 (none), 2 to 12, or 0 (round).");
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

LearnError error_of(const Quality& quality) {
  if (quality.verdict != Verdict::kBad) return LearnError::kSuccess;
  const std::string& worst = quality.reasons.front();
  if (worst == "touches_image_border") return LearnError::kTouchesBorder;
  if (worst == "too_small") return LearnError::kTooSmall;
  if (worst == "low_texture") return LearnError::kLowTexture;
  if (worst == "not_found_again") return LearnError::kNotDistinct;
  return LearnError::kQualityBad;
}

}  // namespace mbncc::teaching
