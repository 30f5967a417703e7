// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/closest_points.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc::evidence {
namespace {

constexpr int kIterations = 10;
// Largest distance of a pair. It shrinks, so that parts of only one contour lose their influence.
constexpr double kFarthest = 0.5;     // [radius of the fixed contour] in the first iteration
constexpr double kShrinking = 0.8;    // factor per iteration
constexpr double kNearest = 3;        // [px] lower bound
constexpr double kLeastCosine = 0.5;  // least cosine between the normals of a pair
constexpr double kMostCells = 200;    // from the anchor to the grid's edge; bounds the memory

int cell_at(double place, double cell, int half) {
  return std::clamp(cvRound(place / cell) + half, 0, 2 * half);
}

/// Index of the point of `contour` nearest to each cell of a grid of 2 `half` + 1 cells.
cv::Mat nearest_points(const templates::ContourTemplate& contour, double cell, int half) {
  cv::Mat empty(2 * half + 1, 2 * half + 1, CV_8UC1, cv::Scalar(255));
  std::vector<cv::Point> cells;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    cells.emplace_back(cell_at(contour.x[i], cell, half), cell_at(contour.y[i], cell, half));
    empty.at<uchar>(cells.back()) = 0;
  }
  cv::Mat distances, labels;
  cv::distanceTransform(empty, distances, labels, cv::DIST_L2, cv::DIST_MASK_5,
                        cv::DIST_LABEL_PIXEL);
  std::vector<int> of_label(contour.size() + 1, 0);
  for (std::size_t i = 0; i < cells.size(); ++i)
    of_label[static_cast<std::size_t>(labels.at<int>(cells[i]))] = static_cast<int>(i);
  for (auto label = labels.begin<int>(); label != labels.end<int>(); ++label)
    *label = of_label[static_cast<std::size_t>(*label)];
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

ClosestPoints::ClosestPoints(const templates::ContourTemplate& fixed) : fixed_(fixed) {
  const double reach = (1 + kFarthest) * fixed.radius() + 1;
  cell_ = std::max(1.0, reach / kMostCells);
  half_ = static_cast<int>(std::ceil(reach / cell_));
  nearest_ = nearest_points(fixed, cell_, half_);
}

std::size_t ClosestPoints::nearest(cv::Point2d place) const {
  return static_cast<std::size_t>(
      nearest_.at<int>(cell_at(place.y, cell_, half_), cell_at(place.x, cell_, half_)));
}

ClosestPoints::Step ClosestPoints::step_at(const templates::ContourTemplate& moved,
                                           const Pose2D& pose, double farthest) const {
  constexpr double kCurvature = 0.15;  // [1/px^2] decrease of an edge's response with the distance
  const Transform placed(pose), turned({0, 0, pose.theta});
  Step step;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const cv::Point2d place = placed({moved.x[i], moved.y[i]});
    const std::size_t k = nearest(place);
    const cv::Point2d normal(fixed_.normal_x[k], fixed_.normal_y[k]);
    const double cosine = normal.dot(turned({moved.normal_x[i], moved.normal_y[i]}));
    const cv::Point2d apart = cv::Point2d(fixed_.x[k], fixed_.y[k]) - place;
    if (cosine < kLeastCosine || cv::norm(apart) > farthest) continue;
    const double distance = normal.dot(apart);
    const cv::Vec3d motion(normal.x, normal.y, (place - pose.position()).cross(normal));
    step.information += motion * motion.t();
    step.vector += distance * motion;
    step.covered += cosine * std::exp(-kCurvature * distance * distance);
  }
  step.covered /= static_cast<double>(std::max<std::size_t>(1, moved.size()));
  return step;
}

RegisteredContour ClosestPoints::align(const templates::ContourTemplate& moved,
                                       const Pose2D& start) const {
  constexpr double kDamping = 1e-3;  // [pairs] for directions that no pair determines
  const double radius = std::max(1.0, fixed_.radius());
  const cv::Matx33d damping = cv::Matx33d::diag({kDamping, kDamping, kDamping * radius * radius});
  RegisteredContour best{start, 0};
  Pose2D pose = start;
  double farthest = kFarthest * radius;
  for (int k = 0;; ++k) {
    const Step step = step_at(moved, pose, farthest);
    if (step.covered > best.covered) best = {pose, step.covered};
    if (k == kIterations) return best;
    const cv::Vec3d motion = (step.information + damping).inv() * step.vector;
    pose = {pose.x + motion[0], pose.y + motion[1], pose.theta + motion[2]};
    farthest = std::max(kNearest, kShrinking * farthest);
  }
}

}  // namespace mbncc::evidence
