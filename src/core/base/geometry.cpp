// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/geometry.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <vector>

namespace mbncc {
namespace {

// Bounding box of the map's pixels, which is much smaller than most images.
cv::Rect box_of(const cv::Mat& map) {
  const cv::Rect box = map.empty() ? cv::Rect() : cv::boundingRect(map);
  if (box.empty()) throw std::invalid_argument("the map has no pixels");
  return box;
}

// The corners of the pixels' convex hull, which determine the smallest enclosing circle.
std::vector<cv::Point> hull_corners(const cv::Mat& map) {
  const cv::Rect box = box_of(map);
  std::vector<cv::Point> row_ends, corners;
  for (int y = box.y; y < box.br().y; ++y) {
    const auto* row = map.ptr(y);
    int first = box.x, last = box.br().x - 1;
    while (first <= last && row[first] == 0) ++first;
    if (first > last) continue;
    while (row[last] == 0) --last;
    row_ends.emplace_back(first, y);
    if (last != first) row_ends.emplace_back(last, y);
  }
  cv::convexHull(row_ends, corners);
  return corners;
}

}  // namespace

double wrap_angle(double radians) {
  const double wrapped = std::remainder(radians, 2 * kPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

double angle_distance(double a, double b, int symmetry) {
  if (symmetry == 0) return 0;
  return std::abs(std::remainder(a - b, 2 * kPi / symmetry));
}

cv::Point2d rotate(cv::Point2d point, double theta) {
  const double c = std::cos(theta), s = std::sin(theta);
  return {c * point.x - s * point.y, s * point.x + c * point.y};
}

cv::Point2d transform(const Pose2D& pose, cv::Point2d point) {
  return rotate(point, pose.theta) + pose.position();
}

Transform::Transform(const Pose2D& pose)
    : cos_(std::cos(pose.theta)), sin_(std::sin(pose.theta)), x_(pose.x), y_(pose.y) {}

cv::Matx23d matrix_of(const Pose2D& pose) {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  return {c, -s, pose.x, s, c, pose.y};
}

Pose2D compose(const Pose2D& outer, const Pose2D& inner) {
  const cv::Point2d position = transform(outer, inner.position());
  return {position.x, position.y, wrap_angle(outer.theta + inner.theta)};
}

cv::Matx33d covariance_at(const cv::Matx33d& covariance, cv::Point2d lever) {
  const cv::Matx33d jacobian(1, 0, -lever.y, 0, 1, lever.x, 0, 0, 1);
  return jacobian * covariance * jacobian.t();
}

Pose2D inverse(const Pose2D& pose) {
  const cv::Point2d position = rotate(-pose.position(), -pose.theta);
  return {position.x, position.y, wrap_angle(-pose.theta)};
}

cv::Point2d centroid(const cv::Mat& map) {
  const cv::Rect box = box_of(map);
  cv::Point2d sum;
  double count = 0;
  for (int y = box.y; y < box.br().y; ++y)
    for (int x = box.x; x < box.br().x; ++x) {
      if (map.at<uchar>(y, x) == 0) continue;
      sum += cv::Point2d(x, y);
      ++count;
    }
  return sum / count;
}

Circle excircle(const cv::Mat& map) {
  cv::Point2f centre;
  float radius = 0;
  cv::minEnclosingCircle(hull_corners(map), centre, radius);
  return {cv::Point2d(centre), static_cast<double>(radius)};
}

double farthest_pixel(const cv::Mat& map, cv::Point2d from) {
  std::vector<cv::Point> pixels;
  cv::findNonZero(map, pixels);
  double farthest = 0;
  for (const auto& pixel : pixels)
    farthest = std::max(farthest, cv::norm(cv::Point2d(pixel) - from));
  return farthest;
}

Circle incircle(const cv::Mat& map) {
  box_of(map);
  cv::Mat padded, distance;
  cv::copyMakeBorder(map, padded, 1, 1, 1, 1, cv::BORDER_CONSTANT, cv::Scalar(0));
  cv::distanceTransform(padded, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  double radius = 0;
  cv::Point where;
  cv::minMaxLoc(distance, nullptr, &radius, nullptr, &where);
  // The distance is measured to the centre of the nearest background pixel, half a pixel beyond the
  // map's edge.
  return {cv::Point2d(where.x - 1, where.y - 1), radius - 0.5};
}

bool is_binary_map(const cv::Mat& map) {
  if (map.empty() || map.type() != CV_8UC1) return false;
  uchar others = 0;
  for (int y = 0; y < map.rows; ++y) {
    const auto* row = map.ptr(y);
    for (int x = 0; x < map.cols; ++x) others |= static_cast<uchar>(row[x] + 1) & 0xfe;
  }
  return others == 0;
}

}  // namespace mbncc
