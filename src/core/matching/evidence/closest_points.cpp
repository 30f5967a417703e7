// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::evidence {
namespace {

constexpr int kIterations = 10;
constexpr double kFarthest = 0.5;  // [radius] of a pair
constexpr double kAlong = 0.5;     // least cosine between the normals of a pair

/// Index of the point of `contour` that is nearest to each pixel of a grid of 2 `half` + 1 pixels.
cv::Mat nearest_points(const templates::ContourTemplate& contour, int half) {
  cv::Mat elsewhere(2 * half + 1, 2 * half + 1, CV_8UC1, cv::Scalar(255));
  std::vector<cv::Point> pixels;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    pixels.emplace_back(cvRound(contour.x[i]) + half, cvRound(contour.y[i]) + half);
    elsewhere.at<uchar>(pixels.back()) = 0;
  }
  cv::Mat distances, labels;
  cv::distanceTransform(elsewhere, distances, labels, cv::DIST_L2, cv::DIST_MASK_5,
                        cv::DIST_LABEL_PIXEL);
  std::vector<int> of_label(contour.size() + 1, 0);
  for (std::size_t i = 0; i < pixels.size(); ++i)
    of_label[static_cast<std::size_t>(labels.at<int>(pixels[i]))] = static_cast<int>(i);
  labels.forEach<int>(
      [&](int& label, const int*) { label = of_label[static_cast<std::size_t>(label)]; });
  return labels;
}

}  // namespace

/// Normal equations of the motion (dx, dy, dtheta about the moved anchor) that closes the distances
/// of the pairs along their normals.
struct ClosestPoints::Step {
  cv::Matx33d information;
  cv::Vec3d vector;
  double covered = 0;
};

ClosestPoints::ClosestPoints(const templates::ContourTemplate& fixed)
    : fixed_(fixed),
      half_(static_cast<int>(std::ceil((1 + kFarthest) * fixed.radius())) + 1),
      grid_(nearest_points(fixed, half_)) {}

std::size_t ClosestPoints::nearest(cv::Point2d place) const {
  const auto inside = [&](double along) {
    return std::clamp(cvRound(along) + half_, 0, 2 * half_);
  };
  return static_cast<std::size_t>(grid_.at<int>(inside(place.y), inside(place.x)));
}

ClosestPoints::Step ClosestPoints::step_at(const templates::ContourTemplate& moved,
                                           const Pose2D& pose) const {
  constexpr double kCurvature = 0.15;  // [1/px^2] as an edge's response falls with its distance
  Step step;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const cv::Point2d arm = rotate({moved.x[i], moved.y[i]}, pose.theta);
    const std::size_t k = nearest(pose.position() + arm);
    const cv::Point2d normal(fixed_.normal_x[k], fixed_.normal_y[k]);
    const double cosine = normal.dot(rotate({moved.normal_x[i], moved.normal_y[i]}, pose.theta));
    const cv::Point2d way = cv::Point2d(fixed_.x[k], fixed_.y[k]) - pose.position() - arm;
    if (cosine < kAlong || cv::norm(way) > kFarthest * fixed_.radius()) continue;
    const double distance = normal.dot(way);
    const cv::Vec3d motion(normal.x, normal.y, arm.cross(normal));
    step.information += motion * motion.t();
    step.vector += distance * motion;
    step.covered += cosine * std::exp(-kCurvature * distance * distance);
  }
  step.covered /= static_cast<double>(std::max<std::size_t>(1, moved.size()));
  return step;
}

LaidContour ClosestPoints::lay(const templates::ContourTemplate& moved, const Pose2D& start) const {
  constexpr double kDamping = 1e-3;
  const double radius = std::max(1.0, fixed_.radius());
  const cv::Matx33d damping = cv::Matx33d::diag({kDamping, kDamping, kDamping * radius * radius});
  LaidContour best{start, -1};
  Pose2D pose = start;
  for (int k = 0; k <= kIterations; ++k) {
    const Step step = step_at(moved, pose);
    if (step.covered > best.covered) best = {pose, step.covered};
    const cv::Vec3d motion = (step.information + damping).inv() * step.vector;
    pose = {pose.x + motion[0], pose.y + motion[1], pose.theta + motion[2]};
  }
  return best;
}

}  // namespace mbncc::evidence
