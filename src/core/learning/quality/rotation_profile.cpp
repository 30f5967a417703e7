// SPDX-License-Identifier: BSD-3-Clause
#include "learning/quality/rotation_profile.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "imaging/pyramid.hpp"
#include "imaging/rectangles.hpp"
#include "mbncc/matching/similarity.hpp"

namespace mbncc::quality {
namespace {

constexpr int kEnoughPoints = 300;  // template points that suffice for the profile

int level_for(double area) {
  int level = 0;
  while (area / (1 << (2 * level)) > 2 * kEnoughPoints) ++level;
  return level;
}

// Template points of the map's box, which starts on the whole image's pixel grid of that level.
MaskedTemplate points_of(const cv::Mat& grey, const cv::Mat& map, const cv::Point2d& anchor,
                         int level) {
  const cv::Rect tight = cv::boundingRect(map);
  const cv::Point start(tight.x >> level << level, tight.y >> level << level);
  const cv::Rect box(start, tight.br());
  return masked_template(grey(box), map(box), anchor - cv::Point2d(start), level);
}

}  // namespace

RotationProfile::RotationProfile(const View& view, const cv::Mat& image) {
  const cv::Point2d centre = centroid(view.map);
  const int reach = static_cast<int>(2 * excircle(view.map).radius) + 4;
  cv::Mat part;
  const cv::Rect around =
      imaging::grown(cv::Rect(cv::Point(centre) + view.origin, cv::Size(1, 1)), reach) &
      cv::Rect({0, 0}, image.size());
  const cv::Mat map = map_within(view, around);
  cv::cvtColor(image(around), part, cv::COLOR_BGR2GRAY);
  const cv::Point2d anchor = centre + cv::Point2d(view.origin - around.tl());

  const int level = level_for(cv::countNonZero(map));
  const MaskedTemplate points = points_of(part, map, anchor, level);
  const cv::Mat at_level = imaging::build_pyramid(part, level).back();
  const cv::Point2d pivot = imaging::to_level(anchor, level);
  for (int step = 0; step < kSteps; ++step) {
    const Pose2D turned{pivot.x, pivot.y, 2 * kPi * step / kSteps};
    similarity_.push_back(mbncc::similarity(points, at_level, turned).value);
  }
}

double RotationProfile::fall_to(double level) const {
  const double step_size = 2 * kPi / kSteps;
  for (int step = 1; step <= kSteps / 2; ++step) {
    // The direction with the slower fall decides, because a rotation in either direction must be
    // detected.
    const double before =
        std::max(similarity_[step - 1], similarity_[(kSteps - step + 1) % kSteps]);
    const double here = std::max(similarity_[step], similarity_[kSteps - step]);
    if (here > level) continue;
    const double part = before > here ? (before - level) / (before - here) : 1;
    return step_size * (step - 1 + std::clamp(part, 0.0, 1.0));
  }
  return kPi;
}

}  // namespace mbncc::quality
