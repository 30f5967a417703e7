// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/map_measures.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "imaging/rectangles.hpp"

namespace mbncc::segmentation {
namespace {

constexpr int kReach = 12;        // [px] margin of the map's surroundings
constexpr double kEdgeSlope = 8;  // [grey levels / px] of an image edge, well above camera noise
constexpr double kMiddleGrey = 128;

cv::Mat grey_of(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

double contrast_under(const cv::Mat& grey, const cv::Mat& map) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(grey, mean, deviation, map);
  return deviation[0];
}

// Slope of the steepest channel. [grey levels / px]
cv::Mat steepest_slope(const cv::Mat& image) {
  cv::Mat smooth, channels[3], slope = cv::Mat::zeros(image.size(), CV_32FC1);
  cv::GaussianBlur(image, smooth, {3, 3}, 0);
  cv::split(smooth, channels);
  for (const cv::Mat& channel : channels) {
    cv::Mat slope_x, slope_y, magnitude;
    cv::Sobel(channel, slope_x, CV_32F, 1, 0, 3, 1.0 / 8);
    cv::Sobel(channel, slope_y, CV_32F, 0, 1, 3, 1.0 / 8);
    cv::magnitude(slope_x, slope_y, magnitude);
    slope = cv::max(slope, magnitude);
  }
  return slope;
}

// Largest slope within a pixel.
cv::Mat slope_nearby(const cv::Mat& image) {
  cv::Mat slope;
  cv::dilate(steepest_slope(image), slope, cv::Mat());
  return slope;
}

// Least slope of an edge. In a dark image weaker edges count, because contrast is relative to the
// light.
double least_slope(const cv::Mat& grey) {
  return kEdgeSlope * std::clamp(cv::mean(grey)[0] / kMiddleGrey, 0.5, 1.0);
}

double part_of_outline(const cv::Mat& pixels, const cv::Mat& map) {
  const cv::Mat outline = outline_pixels(map);
  const int length = cv::countNonZero(outline);
  return length == 0 ? 0 : cv::countNonZero(pixels & outline) / double(length);
}

// Part of the outline with an image edge within a pixel.
double edge_agreement(const cv::Mat& image, const cv::Mat& grey, const cv::Mat& map) {
  return part_of_outline(slope_nearby(image) > least_slope(grey), map);
}

cv::Rect surroundings(const cv::Mat& map) {
  return imaging::grown(cv::boundingRect(map), kReach) & cv::Rect({0, 0}, map.size());
}

}  // namespace

cv::Rect surroundings(const View& view) {
  return imaging::grown({view.origin, view.map.size()}, kReach) & cv::Rect({0, 0}, view.image_size);
}

cv::Mat outline_pixels(const cv::Mat& map) {
  cv::Mat inner;
  cv::erode(map, inner, cv::getStructuringElement(cv::MORPH_CROSS, {3, 3}), {-1, -1}, 1,
            cv::BORDER_CONSTANT, cv::Scalar(0));
  return map & ~inner;
}

void measure_map(const cv::Mat& image, const cv::Mat& map, Quality& quality) {
  const cv::Rect box = surroundings(map);
  const cv::Mat grey = grey_of(image(box)), part = map(box);
  const double radius = std::max(0.5, excircle(part).radius + 0.5);  // out to the pixels' edges
  quality.area = cv::countNonZero(part);
  quality.fill = std::min(1.0, quality.area / (kPi * radius * radius));
  quality.contrast = contrast_under(grey, part);
  quality.edge_agreement = edge_agreement(image(box), grey, part);
}

double edge_agreement(const cv::Mat& image, const cv::Mat& map) {
  const cv::Rect box = surroundings(map);
  return box.empty() ? 0 : edge_agreement(image(box), grey_of(image(box)), map(box));
}

double edges_only_after(const cv::Mat& before, const cv::Mat& after, const cv::Mat& map) {
  constexpr double kWeak = 0.6;  // of the slope after; less is hardly an edge
  const cv::Rect box = surroundings(map);
  if (box.empty()) return 0;
  const cv::Mat slope = slope_nearby(after(box));
  const cv::Mat weak = slope_nearby(before(box)) < kWeak * slope;
  return part_of_outline((slope > least_slope(grey_of(after(box)))) & weak, map(box));
}

double map_iou(const cv::Mat& a, const cv::Mat& b) {
  const int either = cv::countNonZero(a | b);
  return either == 0 ? 0 : cv::countNonZero(a & b) / static_cast<double>(either);
}

double agreement_at(const ObjectModel& object, const Pose2D& found, const cv::Mat& map) {
  double best = 0;
  for (const View& view : object.views) {
    const Pose2D motion = compose(found, inverse(view.reference));
    const cv::Point2d corner = transform(motion, cv::Point2d(view.origin));
    cv::Mat moved;
    cv::warpAffine(view.map, moved, matrix_of({corner.x, corner.y, motion.theta}), map.size(),
                   cv::INTER_NEAREST);
    best = std::max(best, map_iou(moved, map));
  }
  return best;
}

double change_agreement(const cv::Mat& changed, const cv::Mat& map) {
  const cv::Rect box = surroundings(map);
  const cv::Mat change = changed(box), part = map(box);
  const int either = cv::countNonZero(change | part);
  return either == 0 ? 0 : cv::countNonZero(change & part) / double(either);
}

bool touches_border(const cv::Mat& map) {
  return cv::countNonZero(map.row(0)) + cv::countNonZero(map.row(map.rows - 1)) +
             cv::countNonZero(map.col(0)) + cv::countNonZero(map.col(map.cols - 1)) >
         0;
}

}  // namespace mbncc::segmentation
