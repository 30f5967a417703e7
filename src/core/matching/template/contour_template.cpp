// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/contour_template.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "imaging/kernel_views.hpp"
#include "imaging/pyramid.hpp"
#include "simd/lanes.hpp"

namespace mbncc::templates {
namespace {

constexpr int kMotions = 3, kProducts = 6;

}  // namespace

std::vector<EdgePoint> ContourTemplate::edge_of(const MapGeometry& map, int level) {
  return map.edge(std::max(1.5, 0.8 * (1 << level)));
}

ContourTemplate::ContourTemplate(const std::vector<EdgePoint>& edge, cv::Point2d anchor, int level,
                                 std::size_t most) {
  const double side = 1 << level;
  const auto wanted = static_cast<std::size_t>(static_cast<double>(edge.size()) / side);
  count_ = std::min({most, std::max<std::size_t>(8, wanted), edge.size()});
  const std::size_t lanes = kernels::whole_lanes(count_);
  constexpr float kNowhere = -1e6f;
  x.assign(lanes, kNowhere);
  y.assign(lanes, kNowhere);
  for (auto* padded : {&normal_x, &normal_y, &ones}) padded->assign(lanes, 0.f);
  motion.assign(kMotions * lanes, 0.f);
  products.assign(kProducts * lanes, 0.f);
  for (std::size_t i = 0; i < count_; ++i) {
    const EdgePoint& point = edge[i * edge.size() / count_];
    x[i] = static_cast<float>((point.position.x - anchor.x) / side);
    y[i] = static_cast<float>((point.position.y - anchor.y) / side);
    ones[i] = 1;
    radius_ = std::max<double>(radius_, std::hypot(x[i], y[i]));
    const float nx = normal_x[i] = point.normal.x, ny = normal_y[i] = point.normal.y;
    const float turn = ny * x[i] - nx * y[i];
    const std::array<float, kMotions> distance{nx, ny, turn};
    const std::array<float, kProducts> pairs{nx * nx,   nx * ny,   ny * ny,
                                             nx * turn, ny * turn, turn * turn};
    for (std::size_t k = 0; k < kMotions; ++k) motion[k * lanes + i] = distance[k];
    for (std::size_t k = 0; k < kProducts; ++k) products[k * lanes + i] = pairs[k];
  }
}

void ContourTemplate::resize(double factor) {
  for (auto* places : {&x, &y})
    for (auto& place : *places) place *= static_cast<float>(factor);
  radius_ *= factor;
}

void ContourTemplate::mirror() {
  for (auto* values : {&x, &normal_x})
    for (auto& value : *values) value = -value;
}

void read_contour(const ContourTemplate& contour, const cv::Mat& edges, const Pose2D& pose,
                  int reach, ContourSample& sample, double scale) {
  const std::size_t lanes = contour.x.size();
  for (auto* values : {&sample.response, &sample.seen, &sample.pull, &sample.moment})
    values->resize(lanes);
  kernels::read_along_normals(
      imaging::view_of(edges), {contour.x.data(), contour.y.data(), static_cast<int>(lanes)},
      contour.normal_x.data(), contour.normal_y.data(), imaging::placement_of(pose, scale), reach,
      {sample.response.data(), sample.seen.data(), sample.pull.data(), sample.moment.data()});
}

cv::Rect bounding_box(const ContourTemplate& contour, const Pose2D& pose, double scale) {
  const Transform to_image(pose);
  std::vector<cv::Point2f> points;
  for (std::size_t k = 0; k < contour.size(); ++k)
    points.emplace_back(to_image(scale * cv::Point2d(contour.x[k], contour.y[k])));
  return cv::boundingRect(points);
}

double contour_agreement(const ContourTemplate& contour, const ContourSample& sample) {
  const double visible = kernels::product(contour.ones, sample.seen.data());
  if (visible < 4 || 4 * visible < static_cast<double>(contour.size())) return -1;
  return kernels::product(contour.ones, sample.response.data()) / visible;
}

std::vector<int> points_beside(const ContourTemplate& contour, cv::Point2f at) {
  constexpr float kBeside = 1.5F;  // [distance of the nearest point] ...
  constexpr float kSlack = 3;      // [px] ... plus this
  std::vector<float> distances(contour.size());
  for (std::size_t k = 0; k < contour.size(); ++k)
    distances[k] = std::hypot(contour.x[k] - at.x, contour.y[k] - at.y);
  std::vector<int> beside;
  if (distances.empty()) return beside;
  const float most = kBeside * *std::min_element(distances.begin(), distances.end()) + kSlack;
  for (std::size_t k = 0; k < contour.size(); ++k)
    if (distances[k] <= most) beside.push_back(static_cast<int>(k));
  return beside;
}

double contour_found(const ContourTemplate& contour, const ContourSample& sample) {
  const double visible = kernels::product(contour.ones, sample.seen.data());
  const auto found = std::count_if(sample.response.begin(), sample.response.end(), is_clear);
  return static_cast<double>(found) / std::max(1.0, visible);
}

double contour_found_beside(const ContourTemplate& contour, const ContourSample& sample,
                            cv::Point2f at) {
  double seen = 0, found = 0;
  for (const int k : points_beside(contour, at)) {
    seen += sample.seen[k];
    if (is_clear(sample.response[k])) found += sample.seen[k];
  }
  return seen > 0 ? found / seen : 0;
}

ContourPull contour_pull(const ContourTemplate& contour, const ContourSample& sample) {
  // Decrease of a response with the squared distance from its edge, for a blur of about one pixel.
  constexpr double kCurvature = 0.15;
  const auto points = static_cast<int>(contour.x.size());
  float along[kMotions], p[kProducts];
  kernels::dots(contour.motion.data(), contour.x.size(), kMotions, sample.moment.data(), points,
                along);
  kernels::dots(contour.products.data(), contour.x.size(), kProducts, sample.pull.data(), points,
                p);
  const double weight = 2 * kCurvature / static_cast<double>(contour.size());
  ContourPull pull;
  pull.hessian = weight * cv::Matx33d(p[0], p[1], p[3], p[1], p[2], p[4], p[3], p[4], p[5]);
  pull.gradient = -weight * cv::Vec3d(along[0], along[1], along[2]);
  return pull;
}

}  // namespace mbncc::templates
