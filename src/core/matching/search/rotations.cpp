// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/rotations.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "matching/evidence/contour_alignment.hpp"
#include "matching/refinement/gauss_newton.hpp"
#include "matching/search/pose_hypothesis.hpp"

namespace mbncc::search {
namespace {

/// Local maxima of the agreement with `object` at a place over a full turn, in steps of `arc` [px]
/// at the rim, best first. The candidates' values are those of align().
std::vector<templates::Candidate> rotation_peaks(const templates::PoseTemplate& object,
                                                 const scene::SceneLevel& scene,
                                                 const templates::Candidate& place, double arc) {
  const double rim = 2 * kPi * object.surface.radius();
  const int count = std::max(24, static_cast<int>(std::ceil(rim / arc)));
  std::vector<templates::Candidate> turned(count, place);
  for (int k = 0; k < count; ++k) {
    turned[k].pose.theta = wrap_angle(place.pose.theta + 2 * kPi * k / count);
    turned[k].value = refinement::align(object, scene, turned[k].pose, 0).value;
  }
  std::vector<templates::Candidate> peaks;
  for (int k = 0; k < count; ++k)
    if (turned[k].value >= turned[(k + 1) % count].value &&
        turned[k].value > turned[(k + count - 1) % count].value)
      peaks.push_back(turned[k]);
  templates::sort_by_value(peaks);
  return peaks;
}

/// `place` rotated by half a turn about the map's centroid, which makes an elongated object cover
/// itself best. This may move the anchor farther than the shifts reach.
templates::Candidate half_turned(const prepared::PreparedView& view,
                                 const templates::Candidate& place) {
  const templates::SurfaceTemplate& surface = view.tracked[0].surface;
  const auto mean = [&](const std::vector<float>& values) {
    return std::accumulate(values.begin(), values.begin() + surface.size(), 0.0) /
           static_cast<double>(surface.size());
  };
  return {compose(place.pose, {2 * mean(surface.x), 2 * mean(surface.y), kPi}), place.level, 0};
}

/// The first of `peaks`, shifted to the best fit of the outline, best first. If shading displaced
/// one rotation by pixels, the opposite rotation is displaced in the opposite direction.
std::vector<templates::Candidate> shifted_onto_edges(const prepared::PreparedView& view,
                                                     const scene::SceneImage& scene,
                                                     std::vector<templates::Candidate> peaks) {
  constexpr std::size_t kMost = 6;
  if (peaks.size() > kMost) peaks.resize(kMost);
  for (auto& peak : peaks)
    peak = evidence::shifted_onto_edges(view.tracked[0].contour, scene.levels[0], peak);
  templates::sort_by_value(peaks);
  return peaks;
}

/// The poses aligned from the first `most` of `starts`, with their log-odds as values.
std::vector<templates::Candidate> reached_from(const prepared::PreparedView& view,
                                               const scene::SceneImage& scene,
                                               std::vector<templates::Candidate> starts,
                                               std::size_t most) {
  constexpr int kIterations = 5;
  if (starts.size() > most) starts.resize(most);
  for (auto& start : starts) {
    const PoseHypothesis reached =
        aligned_from(view, view.tracked[0], scene.levels[0], start.pose, kIterations);
    start = {reached.pose, 0, reached.odds};
  }
  return starts;
}

/// Direction [px] of the surface's longest extension; {0, 0} unless that is `least` times as long
/// as the shortest.
cv::Point2d long_axis(const templates::SurfaceTemplate& surface, double least) {
  cv::Mat points(static_cast<int>(surface.size()), 2, CV_32F);
  for (int i = 0; i < points.rows; ++i) {
    points.at<float>(i, 0) = surface.x[static_cast<std::size_t>(i)];
    points.at<float>(i, 1) = surface.y[static_cast<std::size_t>(i)];
  }
  if (points.rows < 2) return {0, 0};
  const cv::PCA axes(points, cv::noArray(), cv::PCA::DATA_AS_ROW);
  if (axes.eigenvalues.at<float>(0) < least * least * axes.eigenvalues.at<float>(1)) return {0, 0};
  return {axes.eigenvectors.at<float>(0, 0), axes.eigenvectors.at<float>(0, 1)};
}

}  // namespace

std::vector<templates::Candidate> shifts_at(const prepared::PreparedView& view,
                                            const scene::SceneImage& scene,
                                            const templates::Candidate& place) {
  constexpr double kLong = 4, kStep = 2, kNear = 6;  // [1], [px], [px]
  constexpr std::size_t kMost = 2;
  const cv::Point2d axis = rotate(long_axis(view.tracked[0].surface, kLong), place.pose.theta);
  if (axis == cv::Point2d(0, 0)) return {};
  const int reach = static_cast<int>(0.5 * view.shape.radius() / kStep);
  std::vector<templates::Candidate> shifted, peaks;
  for (int k = -reach; k <= reach; ++k) {
    const cv::Point2d at = place.pose.position() + k * kStep * axis;
    const Pose2D pose{at.x, at.y, place.pose.theta};
    shifted.push_back({pose, 0, refinement::align(view.rough[0], scene.levels[0], pose, 0).value});
  }
  for (std::size_t k = 1; k + 1 < shifted.size(); ++k)
    if (shifted[k].value >= shifted[k - 1].value && shifted[k].value > shifted[k + 1].value &&
        cv::norm(shifted[k].pose.position() - place.pose.position()) > kNear)
      peaks.push_back(shifted[k]);
  templates::sort_by_value(peaks);
  return reached_from(view, scene, peaks, kMost);
}

std::vector<templates::Candidate> rotations_at(const prepared::PreparedView& view,
                                               const scene::SceneImage& scene,
                                               const templates::Candidate& place) {
  constexpr std::size_t kMost = 3;
  auto peaks = rotation_peaks(view.rough[0], scene.levels[0], place, 2);
  std::vector<templates::Candidate> turned = reached_from(view, scene, peaks, kMost);
  peaks.insert(peaks.begin(), half_turned(view, place));
  const auto shifted = reached_from(view, scene, shifted_onto_edges(view, scene, peaks), kMost);
  turned.insert(turned.end(), shifted.begin(), shifted.end());
  templates::keep_distinct(turned, kMost, {1.5, view.shape.radius()});
  return turned;
}

}  // namespace mbncc::search
