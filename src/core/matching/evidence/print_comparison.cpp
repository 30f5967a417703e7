// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/print_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"
#include "matching/evidence/differing_groups.hpp"
#include "matching/evidence/gain_offset.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kSlack = 2;     // [px] tolerated displacement, and width of the rim
constexpr double kUnit = 50;  // steps per natural logarithm
constexpr int kMiddle = 128;  // value of a logarithm of 0

/// Least differences, as natural logarithms.
struct Least {
  double chroma, brightness;
};
constexpr Least kColours{0.4, 0.9};  // shading changes the brightness of a colour by less
constexpr Least kDetail{0.12, 0.2};

cv::Mat square(int reach) {
  return cv::Mat::ones(2 * reach + 1, 2 * reach + 1, CV_8U);
}

/// CV_8UC3: logarithms of red/green, blue/green and brightness. `dark` [grey levels] is added to
/// bound noise in dark colours.
cv::Mat logarithms(const cv::Mat& colour, double dark) {
  constexpr int kLeast = 50;
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
cv::Mat only_in(const cv::Mat& one, const cv::Mat& other, const Least& least) {
  cv::Mat low, high, above, below, channels[3];
  cv::erode(other, low, square(kSlack));
  cv::dilate(other, high, square(kSlack));
  cv::subtract(one, high, above);
  cv::subtract(low, one, below);
  cv::split(cv::max(above, below), channels);
  return (cv::max(channels[0], channels[1]) > kUnit * least.chroma) |
         (channels[2] > kUnit * least.brightness);
}

cv::Mat differing(const cv::Mat& one, const cv::Mat& other, const Least& least) {
  return only_in(one, other, least) | only_in(other, one, least);
}

/// CV_8UC3: `colours` relative to their mean around each pixel, over the pixels of `where`.
cv::Mat relative_to_surroundings(const cv::Mat& colours, const cv::Mat& where) {
  constexpr int kAround = 17;  // [px] side of the square
  const auto sum = [](const cv::Mat& values) {
    cv::Mat sums;
    cv::boxFilter(values, sums, CV_32F, {kAround, kAround}, {-1, -1}, false, cv::BORDER_CONSTANT);
    return sums;
  };
  cv::Mat counted = cv::Mat::zeros(colours.size(), CV_8UC3), ones = counted.clone(), relative;
  colours.copyTo(counted, where);
  ones.setTo(cv::Scalar::all(1), where);
  const cv::Mat mean = sum(counted) / cv::max(sum(ones), 1);
  cv::subtract(colours, mean, relative, {}, CV_32F);
  relative += cv::Scalar::all(kMiddle);
  relative.convertTo(relative, CV_8U);
  relative.setTo(cv::Scalar::all(kMiddle), ~where);
  return relative;
}

/// `colour` in another light.
cv::Mat lit(const cv::Mat& colour, const GainOffset& light) {
  cv::Mat values(1, 256, CV_8UC1), result;
  for (int value = 0; value < 256; ++value)
    values.at<uchar>(value) = cv::saturate_cast<uchar>(light.of(static_cast<float>(value)));
  cv::LUT(colour, values, result);
  return result;
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
  for (const Group& group : connected_groups(unexpected)) {
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

}  // namespace

PrintComparison::PrintComparison(const scene::SceneLevel& lesson, const cv::Mat& map,
                                 cv::Point2d anchor)
    : lesson_(lesson, map, anchor, kSlack) {}

PrintComparison::Colours PrintComparison::colours_at(const scene::SceneLevel& scene,
                                                     const templates::PoseTemplate& object,
                                                     const templates::PoseSample& sample,
                                                     const Pose2D& pose, double scale) const {
  constexpr double kDark = 30;  // [grey levels] in the lesson
  const cv::Mat& image = scene.around(pose, scale * lesson_.reach + 2 * kSlack).colour;
  const LessonPixels pixels(lesson_, image.size(), pose, scale);
  const cv::Mat seen = pixels.read(image, cv::INTER_LINEAR);
  const GainOffset light = light_on(object.surface, sample.surface);
  const cv::Mat expected = lit(lesson_.colour, light);
  return {logarithms(seen, kDark * light.factor), logarithms(expected, kDark * light.factor),
          pixels.inside() & lesson_.inside & ~highlights(seen, expected)};
}

PrintDifference PrintComparison::largest_difference(const cv::Mat& differing,
                                                    const cv::Mat& compared,
                                                    const templates::PoseTemplate& object,
                                                    const templates::PoseSample& sample) const {
  constexpr double kLeastFound = 0.7;  // least part of the outline found beside a group
  const auto found = [&](const cv::Point2d& at) {
    return templates::contour_found_beside(object.contour, sample.contour, at - lesson_.anchor) >
           kLeastFound;
  };
  const LargestGroups groups = largest_groups(differing, compared, 1, found);
  const double side = std::sqrt(std::max(1, lesson_.area));
  return {groups.largest / side, groups.enclosed / side};
}

PrintDifference PrintComparison::difference(const scene::SceneLevel& scene,
                                            const templates::PoseTemplate& object,
                                            const templates::PoseSample& sample, const Pose2D& pose,
                                            double scale) const {
  const Colours colours = colours_at(scene, object, sample, pose, scale);
  return largest_difference(differing(colours.seen, colours.learned, kColours), colours.compared,
                            object, sample);
}

double PrintComparison::difference_in_detail(const scene::SceneLevel& scene,
                                             const templates::PoseTemplate& object,
                                             const templates::PoseSample& sample,
                                             const Pose2D& pose, double scale) const {
  const Colours colours = colours_at(scene, object, sample, pose, scale);
  const auto detail = [&](const cv::Mat& values) {
    return relative_to_surroundings(values, colours.compared);
  };
  return largest_difference(differing(detail(colours.seen), detail(colours.learned), kDetail),
                            colours.compared, object, sample)
      .largest;
}

}  // namespace mbncc::evidence
