// SPDX-License-Identifier: BSD-3-Clause
#include "sim/outline.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/random.hpp"

namespace mbncc::sim {
namespace {

using Outline = std::vector<cv::Point2d>;

Outline shard(cv::RNG& random) {
  const int corners = random.uniform(5, 9);
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + random.uniform(-0.3, 0.3)) / corners;
    outline.push_back(rotate({random.uniform(0.5, 1.0), 0}, angle));
  }
  return outline;
}

Outline pebble(cv::RNG& random) {
  double amplitude[4], phase[4];
  for (int k = 0; k < 4; ++k) {
    amplitude[k] = random.uniform(0.05, 0.4) / (k + 2);
    phase[k] = random.uniform(0.0, 2 * kPi);
  }
  Outline outline;
  for (int i = 0; i < 72; ++i) {
    const double angle = 2 * kPi * i / 72;
    double radius = 1;
    for (int k = 0; k < 4; ++k) radius += amplitude[k] * std::cos((k + 1) * angle + phase[k]);
    outline.push_back(rotate({radius, 0}, angle));
  }
  return outline;
}

Outline bracket(cv::RNG& random) {
  const double bar = random.uniform(0.35, 0.5), arm = random.uniform(0.7, 1.0);
  const double slant = random.uniform(0.0, 0.2);
  return {{0, 0}, {1, slant}, {1, bar}, {bar, bar}, {bar + slant, arm}, {0, arm}};
}

Outline hammer(cv::RNG& random) {
  const double half = random.uniform(0.1, 0.16), head = random.uniform(0.3, 0.45);
  const double claw = random.uniform(0.2, 0.35);
  return {{0, -half},   {1, -half},         {1, -head}, {1.3, -head}, {1.3, 0.1},
          {1.45, claw}, {1.05, head * 0.8}, {1, half},  {0, half}};
}

Outline spanner(cv::RNG& random) {
  const double half = random.uniform(0.1, 0.15), jaw = random.uniform(0.26, 0.34);
  const double depth = random.uniform(0.2, 0.3), end = random.uniform(0.18, 0.26);
  return {{-0.15, end},        {0.15, -end}, {0.25, -half}, {1, -half},
          {1.15, -jaw},        {1.5, -jaw},  {1.52, -0.12}, {1.5 - depth, -0.1},
          {1.5 - depth, 0.12}, {1.42, 0.14}, {1.4, jaw},    {1.15, jaw},
          {1, half},           {0.25, half}, {0.15, end},   {-0.15, end}};
}

Outline draw_kind(cv::RNG& random) {
  switch (random.uniform(0, 5)) {
    case 0:
      return shard(random);
    case 1:
      return pebble(random);
    case 2:
      return bracket(random);
    case 3:
      return hammer(random);
    default:
      return spanner(random);
  }
}

/// Chaikin's corner cutting.
Outline rounded(const Outline& outline) {
  Outline result;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const cv::Point2d a = outline[i], b = outline[(i + 1) % outline.size()];
    result.push_back(0.85 * a + 0.15 * b);
    result.push_back(0.15 * a + 0.85 * b);
  }
  return result;
}

std::vector<cv::Point2f> as_float(const Outline& outline) {
  return {outline.begin(), outline.end()};
}

void shift(Outline& outline, cv::Point2d by) {
  for (auto& point : outline) point += by;
}

/// Rotates the longest extent to x and scales y to the given elongation.
void stretch(Outline& outline, double elongation) {
  const cv::RotatedRect box = cv::minAreaRect(as_float(outline));
  const bool upright = box.size.height > box.size.width;
  const double longest = std::max(box.size.width, box.size.height);
  const double shortest = std::min(box.size.width, box.size.height);
  const double angle = to_radians(box.angle) + (upright ? kPi / 2 : 0);
  for (auto& point : outline) {
    point = rotate(point, -angle);
    point.y *= longest / (elongation * shortest);
  }
}

/// Centroid of the area, by Green's theorem.
cv::Point2d area_centroid(const Outline& outline) {
  double area = 0;
  cv::Point2d moment;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const cv::Point2d a = outline[i], b = outline[(i + 1) % outline.size()];
    const double cross = a.cross(b);
    area += cross / 2;
    moment += (a + b) * (cross / 6);
  }
  return moment / area;
}

}  // namespace

std::vector<cv::Point2d> object_outline(const SceneObject& object) {
  cv::RNG random = generator(object.seed, 3);
  Outline outline = rounded(rounded(draw_kind(random)));
  stretch(outline, object.elongation);
  cv::Point2f centre;
  float radius = 1;
  cv::minEnclosingCircle(as_float(outline), centre, radius);
  for (auto& point : outline) point *= object.diameter / (2 * radius);
  shift(outline, -area_centroid(outline));
  return outline;
}

}  // namespace mbncc::sim
