// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/surface_template.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "imaging/gradient_orientation.hpp"
#include "imaging/pyramid.hpp"
#include "imaging/sampling.hpp"
#include "simd/lanes.hpp"

namespace mbncc::templates {
namespace {

constexpr float kNowhere = -1e6f;  // lies outside of every image

}  // namespace

SurfaceTemplate::SurfaceTemplate(const Source& source, cv::Point2d anchor, std::size_t most) {
  SamplePoints chosen = choose_surface_points(source.map, source.map_size, source.level, most);
  points_ = std::move(chosen.points);
  block_ends = std::move(chosen.block_ends);
  place_points(imaging::to_level(anchor, source.level));
  read_colours(source.pixels);
  measure_texture();
  read_gradients(source.pixels);
  basis = ShadingBasis(points_, x, y, radius_);
  project();
  read_slopes(source.pixels);
}

void SurfaceTemplate::place_points(cv::Point2d origin) {
  x.assign(kernels::whole_lanes(size()), kNowhere);
  y = x;
  for (std::size_t i = 0; i < size(); ++i) {
    x[i] = static_cast<float>(points_[i].at.x - origin.x);
    y[i] = static_cast<float>(points_[i].at.y - origin.y);
    radius_ = std::max<double>(radius_, std::hypot(x[i], y[i]));
  }
}

void SurfaceTemplate::resize(double factor) {
  for (auto* places : {&x, &y})
    for (auto& place : *places) place *= static_cast<float>(factor);
  radius_ *= factor;
}

void SurfaceTemplate::mirror() {
  // A gradient is stored with twice its angle, so that mirroring changes the sign of its y
  // component.
  for (auto* values : {&x, &gradient_y})
    for (auto& value : *values) value = -value;
}

void SurfaceTemplate::read_colours(const scene::PreparedPixels& image) {
  const imaging::ColourSampler colour_at(image.colour);
  const auto right = static_cast<float>(image.size().width) - 1.02f;
  const auto bottom = static_cast<float>(image.size().height) - 1.02f;
  for (auto* values : {&planes[0], &planes[1], &planes[2], &brightness})
    values->assign(padded(), 0.f);
  std::vector<float> ones(padded(), 0.f);
  for (std::size_t i = 0; i < size(); ++i) {
    float colour[kChannels] = {};
    colour_at(std::clamp(points_[i].at.x, 0.f, right), std::clamp(points_[i].at.y, 0.f, bottom),
              colour);
    for (int c = 0; c < kChannels; ++c) {
      planes[c][i] = colour[c];
      brightness[i] += colour[c];
    }
    ones[i] = 1;
  }
  histogram = imaging::chroma_histogram(planes, ones);
}

void SurfaceTemplate::measure_texture() {
  constexpr double kPlain = 200;  // [grey^2] variance caused by noise and shading alone
  const auto count = static_cast<double>(std::max<std::size_t>(1, size()));
  double variance = 0;
  for (const auto& plane : planes) {
    const double mean = std::accumulate(plane.begin(), plane.end(), 0.0) / count;
    variance += (kernels::product(plane, plane.data()) / count - mean * mean) / kChannels;
  }
  texture_ = variance / (variance + kPlain);
}

void SurfaceTemplate::read_gradients(const scene::PreparedPixels& image) {
  constexpr float kNoise = 2.5f;  // [grey levels per pixel]
  gradient_x.assign(padded(), 0.f);
  gradient_y.assign(padded(), 0.f);
  const cv::Mat gradients = imaging::strongest_gradient(image.colour);
  for (std::size_t i = 0; i < size(); ++i) {
    const SurfacePoint& point = points_[i];
    if (point.depth <= 2.5f) continue;
    const int column = std::clamp(cvRound(point.at.x), 0, image.size().width - 1);
    const int row = std::clamp(cvRound(point.at.y), 0, image.size().height - 1);
    const auto gradient = gradients.at<cv::Vec2s>(row, column);
    const float gx = gradient[0] / 8.f, gy = gradient[1] / 8.f;
    const float square = gx * gx + gy * gy + 1e-6f;
    const float weight = std::max(0.f, std::sqrt(square) - kNoise);
    gradient_x[i] = weight * (gx * gx - gy * gy) / square;
    gradient_y[i] = weight * 2 * gx * gy / square;
    gradient_total += weight;
  }
}

void SurfaceTemplate::project() {
  for (int c = 0; c < kChannels; ++c) {
    projected[c] = planes[c];
    basis.project_out(projected[c]);
    projected_energy += kernels::product(projected[c], projected[c].data());
  }
}

void SurfaceTemplate::read_slopes(const scene::PreparedPixels& image) {
  auto slopes_of = slopes_in(image);
  for (auto& channel : slopes_of)
    for (auto& row : channel) basis.project_out(row);
  for (int k = 0; k < kMotions; ++k) {
    double along = 0;
    for (int c = 0; c < kChannels; ++c)
      along += kernels::product(slopes_of[c][k], projected[c].data());
    for (int c = 0; c < kChannels; ++c)
      kernels::subtract(slopes_of[c][k], along / (projected_energy + 1e-6), projected[c].data());
  }
  for (int c = 0; c < kChannels; ++c) {
    const auto& rows = slopes_of[c];
    for (const auto& row : rows) slopes[c].insert(slopes[c].end(), row.begin(), row.end());
    slopes[c].insert(slopes[c].end(), projected[c].begin(), projected[c].end());
    for (int j = 0; j < kMotions; ++j)
      for (int k = 0; k < kMotions; ++k)
        slope_product(j, k) += kernels::product(rows[j], rows[k].data());
  }
}

SurfaceTemplate::Slopes SurfaceTemplate::slopes_in(const scene::PreparedPixels& image) const {
  const imaging::ColourSampler colour_at(image.colour);
  Slopes slopes_of;
  for (auto& channel : slopes_of)
    for (auto& row : channel) row.assign(padded(), 0.f);
  for (std::size_t i = 0; i < size(); ++i) {
    float low_x[3], high_x[3], low_y[3], high_y[3];
    const cv::Point2f at = points_[i].at;
    if (!colour_at(at.x - 1, at.y, low_x) || !colour_at(at.x + 1, at.y, high_x) ||
        !colour_at(at.x, at.y - 1, low_y) || !colour_at(at.x, at.y + 1, high_y))
      continue;
    for (int c = 0; c < kChannels; ++c) {
      const float along_x = (high_x[c] - low_x[c]) / 2, along_y = (high_y[c] - low_y[c]) / 2;
      slopes_of[c][0][i] = along_x;
      slopes_of[c][1][i] = along_y;
      slopes_of[c][2][i] = along_y * x[i] - along_x * y[i];
    }
  }
  return slopes_of;
}

}  // namespace mbncc::templates
