// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/print_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"
#include "matching/evidence/gain_offset.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kSlack = 2;  // [px] tolerated displacement, and width of the rim
// Least differences, as natural logarithms: shading changes the brightness of a colour by less.
constexpr double kChroma = 0.4, kBrightness = 0.9;
constexpr double kUnit = 50;  // steps per natural logarithm

cv::Mat square(int reach) {
  return cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
}

/// CV_8UC3: logarithms of red/green, blue/green and brightness. `dark` [grey levels] is added to
/// bound noise in dark colours.
cv::Mat logarithms(const cv::Mat& colour, double dark) {
  constexpr int kMiddle = 128, kLeast = 50;
  int logarithm[256];
  for (int value = 0; value < 256; ++value)
    logarithm[value] = cvRound(kUnit * std::log(value + dark));
  cv::Mat result(colour.size(), CV_8UC3);
  for (int y = 0; y < colour.rows; ++y) {
    const auto* pixel = colour.ptr<cv::Vec3b>(y);
    auto* written = result.ptr<cv::Vec3b>(y);
    for (int x = 0; x < colour.cols; ++x) {
      const int blue = pixel[x][0], green = pixel[x][1], red = pixel[x][2];
      written[x] = {cv::saturate_cast<uchar>(kMiddle + logarithm[red] - logarithm[green]),
                    cv::saturate_cast<uchar>(kMiddle + logarithm[blue] - logarithm[green]),
                    cv::saturate_cast<uchar>(logarithm[(blue + green + red) / 3] - kLeast)};
    }
  }
  return result;
}

/// CV_8UC1: 255 where the values of `one` do not occur nearby in `other`.
cv::Mat only_in(const cv::Mat& one, const cv::Mat& other) {
  cv::Mat low, high, above, below, channels[3];
  cv::erode(other, low, square(kSlack));
  cv::dilate(other, high, square(kSlack));
  cv::subtract(one, high, above);
  cv::subtract(low, one, below);
  cv::split(cv::max(above, below), channels);
  return (cv::max(channels[0], channels[1]) > kUnit * kChroma) |
         (channels[2] > kUnit * kBrightness);
}

/// `colour` in another light.
cv::Mat lit(const cv::Mat& colour, const GainOffset& light) {
  cv::Mat values(1, 256, CV_8UC1), result;
  for (int value = 0; value < 256; ++value)
    values.at<uchar>(value) = cv::saturate_cast<uchar>(light.of(static_cast<float>(value)));
  cv::LUT(colour, values, result);
  return result;
}

struct Group {
  cv::Rect box;
  cv::Point2d centre;
  int size = 0;  ///< [px]
  cv::Mat mask;  ///< CV_8UC1 in the box: 255 at its pixels
};

/// Connected groups of `pixels`.
std::vector<Group> groups_of(const cv::Mat& pixels) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(pixels, labels, stats, centres);
  std::vector<Group> groups;
  for (int i = 1; i < count; ++i) {
    const cv::Rect box = imaging::box_of_component(stats, i);
    groups.push_back({box,
                      {centres.at<double>(i, 0), centres.at<double>(i, 1)},
                      stats.at<int>(i, cv::CC_STAT_AREA),
                      labels(box) == i});
  }
  return groups;
}

/// CV_8UC1: 255 at and beside highlights: pixels that are saturated although the object would not
/// saturate in this light, unless they lie on a part that does, where a print is missing.
cv::Mat highlights(const cv::Mat& seen, const cv::Mat& expected) {
  constexpr int kBeside = 3;  // [px]
  cv::Mat saturated, brightness, result = cv::Mat::zeros(seen.size(), CV_8UC1);
  cv::inRange(seen, cv::Scalar::all(templates::kSaturated), cv::Scalar::all(255), saturated);
  cv::transform(expected, brightness, cv::Matx13f(1.F / 3, 1.F / 3, 1.F / 3));
  const cv::Mat unexpected = saturated & (brightness < templates::kMaySaturate / 3);
  if (cv::countNonZero(unexpected) == 0) return result;
  for (const Group& group : groups_of(unexpected)) {
    const cv::Rect around =
        imaging::grown(group.box, kBeside) & cv::Rect({0, 0}, unexpected.size());
    cv::Mat ring = cv::Mat::zeros(around.size(), CV_8UC1);
    group.mask.copyTo(ring(group.box - around.tl()));
    cv::dilate(ring, ring, square(kBeside));
    ring &= ~unexpected(around);
    if (2 * cv::countNonZero(ring & saturated(around)) <= cv::countNonZero(ring))
      result(group.box) |= group.mask;
  }
  cv::dilate(result, result, square(kBeside));
  return result;
}

/// Whether most of the contour is found beside `at` [px] relative to the anchor.
bool outline_is_found_beside(const cv::Point2d& at, const templates::ContourTemplate& contour,
                             const templates::ContourSample& sample) {
  constexpr float kMost = 0.7F;
  float seen = 0, found = 0;
  for (const int k : templates::points_beside(contour, at)) {
    seen += sample.seen[k];
    if (templates::is_clear(sample.response[k])) found += sample.seen[k];
  }
  return found > kMost * seen;
}

}  // namespace

PrintComparison::PrintComparison(const scene::SceneLevel& lesson, const cv::Mat& map,
                                 cv::Point2d anchor) {
  const cv::Rect box = cv::boundingRect(map);
  colour_ = lesson.whole().colour(box).clone();
  anchor_ = anchor - cv::Point2d(box.tl());
  for (const int x : {0, box.width})
    for (const int y : {0, box.height})
      reach_ = std::max(reach_, cv::norm(cv::Point2d(x, y) - anchor_));
  cv::erode(map(box).clone(), inside_, square(kSlack), {-1, -1}, 1, cv::BORDER_CONSTANT,
            cv::Scalar(0));
}

PrintDifference PrintComparison::difference(const scene::SceneLevel& scene,
                                            const templates::PoseTemplate& object,
                                            const Pose2D& pose, double scale) const {
  constexpr double kDark = 30;  // [grey levels] in the lesson
  const int area = cv::countNonZero(inside_);
  if (area == 0) return {};
  const scene::PreparedPixels image =
      scene.around(pose, scale * std::max(reach_, object.reach()) + 2 * kSlack);
  const GainOffset light = light_on(object.surface, image, pose, scale);
  const Seen seen = at_pose(image.colour, pose, scale);
  const cv::Mat expected = lit(colour_, light);
  const cv::Mat where = seen.inside & ~highlights(seen.colour, expected);
  const cv::Mat here = logarithms(seen.colour, kDark * light.factor);
  const cv::Mat learned = logarithms(expected, kDark * light.factor);
  cv::Mat rim;
  cv::dilate(~where, rim, square(1));
  templates::ContourSample outline;
  templates::read_contour(object.contour, image.edges, pose, 0, outline, scale);
  int largest = 0, enclosed = 0;
  for (const Group& group : groups_of((only_in(here, learned) | only_in(learned, here)) & where)) {
    if (group.size <= enclosed) continue;
    if (!outline_is_found_beside(group.centre - anchor_, object.contour, outline)) continue;
    largest = std::max(largest, group.size);
    if (cv::countNonZero(group.mask & rim(group.box)) == 0) enclosed = group.size;
  }
  return {largest / std::sqrt(area), enclosed / std::sqrt(area)};
}

PrintComparison::Seen PrintComparison::at_pose(const cv::Mat& image, const Pose2D& pose,
                                               double scale) const {
  const Transform placed(pose);
  std::vector<cv::Point2f> corners;
  for (const int x : {0, inside_.cols})
    for (const int y : {0, inside_.rows})
      corners.emplace_back(placed(scale * (cv::Point2d(x, y) - anchor_)));
  const cv::Rect box =
      imaging::grown(cv::boundingRect(corners), kSlack) & cv::Rect({0, 0}, image.size());
  Seen seen{cv::Mat::zeros(inside_.size(), CV_8UC3), cv::Mat::zeros(inside_.size(), CV_8UC1)};
  if (box.empty()) return seen;
  const cv::Point2d first = placed(-scale * anchor_) - cv::Point2d(box.tl());
  const cv::Point2d right = rotate({scale, 0}, pose.theta), down = rotate({0, scale}, pose.theta);
  const cv::Matx23d from_lesson(right.x, down.x, first.x, right.y, down.y, first.y);
  cv::warpAffine(image(box), seen.colour, from_lesson, inside_.size(),
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  cv::warpAffine(cv::Mat(box.size(), CV_8UC1, cv::Scalar(255)), seen.inside, from_lesson,
                 inside_.size(), cv::INTER_NEAREST | cv::WARP_INVERSE_MAP);
  seen.inside &= inside_;
  return seen;
}

}  // namespace mbncc::evidence
