// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/contour_alternative.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/evidence/contour_alignment.hpp"

namespace mbncc::evidence {
namespace {

/// Unit vector along the longest extension of the contour's points.
cv::Point2d main_axis(const templates::ContourTemplate& contour) {
  cv::Mat points(static_cast<int>(contour.size()), 2, CV_32F);
  for (int i = 0; i < points.rows; ++i) {
    points.at<float>(i, 0) = contour.x[static_cast<std::size_t>(i)];
    points.at<float>(i, 1) = contour.y[static_cast<std::size_t>(i)];
  }
  const cv::PCA axes(points, cv::noArray(), cv::PCA::DATA_AS_ROW);
  return {axes.eigenvectors.at<float>(0, 0), axes.eigenvectors.at<float>(0, 1)};
}

/// Ends of a contour.
class ContourEnds {
 public:
  explicit ContourEnds(const templates::ContourTemplate& contour) : axis_(main_axis(contour)) {
    constexpr double kAlong = 0.6;                // least part of a normal along the axis
    constexpr double kThird = 0.15, kCap = 0.42;  // [length] from the middle
    std::vector<double> along;
    for (std::size_t i = 0; i < contour.size(); ++i)
      along.push_back(axis_.x * contour.x[i] + axis_.y * contour.y[i]);
    const auto [low, high] = std::minmax_element(along.begin(), along.end());
    const double middle = (*low + *high) / 2;
    length_ = *high - *low;
    for (const double sign : {-1., 1.})
      for (const double least : {kThird, kCap}) {
        std::vector<std::size_t> points;
        for (std::size_t i = 0; i < contour.size(); ++i)
          if (std::abs(axis_.x * contour.normal_x[i] + axis_.y * contour.normal_y[i]) > kAlong &&
              sign * (along[i] - middle) > least * length_)
            points.push_back(i);
        if (points.size() >= kLeast) ends_.push_back(points);
      }
  }

  double length() const { return length_; }
  cv::Point2d axis() const { return axis_; }

  /// Mean response of each end; -1 where less than half of it is visible.
  std::vector<double> responses(const templates::ContourSample& sample) const {
    std::vector<double> means;
    for (const auto& points : ends_) {
      double sum = 0, seen = 0;
      for (const std::size_t i : points) {
        sum += sample.response[i];
        seen += sample.seen[i];
      }
      means.push_back(2 * seen < static_cast<double>(points.size()) ? -1 : sum / seen);
    }
    return means;
  }

 private:
  static constexpr std::size_t kLeast = 3;  // points

  cv::Point2d axis_;
  double length_ = 0;  // [px]
  std::vector<std::vector<std::size_t>> ends_;
};

}  // namespace

double advantage_of_displaced_end(const templates::ContourTemplate& contour,
                                  const scene::SceneLevel& scene, const Pose2D& pose,
                                  double scale) {
  constexpr double kParts[] = {0.04, 0.06, 0.08, 0.1, 0.125, 0.15, 0.2};  // of the length
  constexpr double kNearest = 4;                                          // [px]
  if (contour.size() == 0) return 0;
  const ContourEnds ends(contour);
  const double farthest = kParts[std::size(kParts) - 1] * ends.length();
  const cv::Mat& edges = scene.around(pose, scale * (contour.radius() + farthest)).edges;
  templates::ContourSample sample;
  const auto responses_at = [&](double way) {
    const cv::Point2d at = pose.position() + scale * way * rotate(ends.axis(), pose.theta);
    templates::read_contour(contour, edges, {at.x, at.y, pose.theta}, 0, sample, scale);
    return ends.responses(sample);
  };
  const std::vector<double> here = responses_at(0);
  double best = -1;
  for (const double part : kParts)
    for (const double way : {-part * ends.length(), part * ends.length()}) {
      if (std::abs(way) < kNearest) continue;
      const std::vector<double> there = responses_at(way);
      for (std::size_t i = 0; i < here.size(); ++i)
        if (here[i] > -1) best = std::max(best, there[i] - here[i]);
    }
  return best;
}

double advantage_elsewhere(const templates::ContourTemplate& contour,
                           const scene::SceneLevel& scene, const Pose2D& pose, double scale) {
  constexpr double kNearest = 2.9;    // [px] nearer poses are the same place within its accuracy
  constexpr double kStep = 2;         // [px] small enough not to skip an edge
  constexpr int kFarthest = 3;        // steps along x and y
  constexpr double kWorse = 0.1;      // difference in agreement that alignment cannot make up for
  constexpr int kAlignmentSteps = 4;  // steps of a pixel
  constexpr double kSlack = 20;       // [px] more than the distance to the farthest place
  ContourAlignment agreement(contour, scene.around(pose, scale * contour.radius() + kSlack), scale);
  const auto elsewhere = [&](const Pose2D& other) {
    return std::hypot(other.x - pose.x, other.y - pose.y) >= kNearest;
  };
  const double here = agreement.at(pose);
  double best = -1;
  for (int i = -kFarthest; i <= kFarthest; ++i)
    for (int j = -kFarthest; j <= kFarthest; ++j) {
      const Pose2D start{pose.x + kStep * i, pose.y + kStep * j, pose.theta};
      if (!elsewhere(start)) continue;
      AlignedContourPose there{start, agreement.at(start)};
      if (there.agreement > here - kWorse)
        there = agreement.aligned(start, kAlignmentSteps, elsewhere);
      best = std::max(best, there.agreement);
    }
  return best - here;
}

}  // namespace mbncc::evidence
