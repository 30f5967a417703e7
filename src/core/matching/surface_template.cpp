#include "matching/surface_template.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "matching/edge_picture.hpp"
#include "matching/padded_vectors.hpp"
#include "matching/sampling.hpp"
#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

constexpr float kNowhere = -1e6f;  // lies outside of every picture

}  // namespace

SurfaceTemplate::SurfaceTemplate(const Source& source, cv::Point2d anchor, std::size_t most) {
  const cv::Point2d origin = to_level(anchor, source.level);
  choose_points(source, most);
  const int depth = size() >= 240 ? 3 : size() >= 100 ? 2 : size() >= 50 ? 1 : 0;
  split_blocks(sites_.begin(), sites_.end(), depth);
  place_points(origin);
  if (mixed_)
    read_unmixed_colours(source.picture, origin);
  else
    read_colours(source.surface);
  measure_texture();
  read_gradients(source.surface);
  build_basis();
  project();
  read_slopes(source.surface);
}

/// Away from the edge, where picture pixels mix with the background; all of a narrow map.
void SurfaceTemplate::choose_points(const Source& source, std::size_t most) {
  const int side = 1 << source.level;
  const std::size_t enough = source.level == 0 ? 100 : 40;
  const double need = source.level == 0 ? 1.9 : 0.5 + 0.75 * side;
  for (int y = side / 2; y < source.map_size.height; y += side)
    for (int x = side / 2; x < source.map_size.width; x += side) {
      const float depth = source.map.depth({x, y});
      if (depth <= need) continue;
      const cv::Point2f at(to_level(cv::Point2d(x, y), source.level));
      sites_.push_back({at, depth, source.map.inward({x, y}), {}});
    }
  if (sites_.size() < enough) choose_mixed_points(source);
  std::mt19937 random(5);
  for (std::size_t i = 0; i + 1 < sites_.size() && i < most; ++i)
    std::swap(sites_[i], sites_[i + random() % (sites_.size() - i)]);
  if (sites_.size() > most) sites_.resize(most);
}

void SurfaceTemplate::choose_mixed_points(const Source& source) {
  constexpr float kShown = 0.4f;       // least share of the object, ...
  constexpr std::ptrdiff_t kFew = 12;  // ... where that leaves more points
  const int side = 1 << source.level;
  const Coverage coverage(source.map, source.level);
  const auto at_level = [&](cv::Point2f place) {
    return cv::Point2f(to_level(cv::Point2d(place), source.level));
  };
  mixed_ = true;
  sites_.clear();
  for (int y = side / 2; y < source.map_size.height; y += side)
    for (int x = side / 2; x < source.map_size.width; x += side) {
      const cv::Point pixel(x, y);
      const float depth = source.map.depth(pixel);
      if (depth <= 0) continue;
      Mixture mixture = coverage.at(pixel);
      for (auto& place : mixture.beyond) place = at_level(place);
      sites_.push_back({at_level(cv::Point2f(pixel)), depth, source.map.inward(pixel), mixture});
    }
  const auto shown = std::stable_partition(
      sites_.begin(), sites_.end(), [](const Site& site) { return site.mixture.share >= kShown; });
  if (shown - sites_.begin() >= kFew) sites_.erase(shown, sites_.end());
}

/// Halves the points along their longer side, `depth` times.
void SurfaceTemplate::split_blocks(Sites::iterator first, Sites::iterator last, int depth) {
  if (depth == 0) {
    block_ends.push_back(static_cast<int>(last - sites_.begin()));
    return;
  }
  const auto left = [](const Site& a, const Site& b) { return a.at.x < b.at.x; };
  const auto above = [](const Site& a, const Site& b) { return a.at.y < b.at.y; };
  const auto [west, east] = std::minmax_element(first, last, left);
  const auto [north, south] = std::minmax_element(first, last, above);
  const auto middle = first + (last - first) / 2;
  if (east->at.x - west->at.x > south->at.y - north->at.y)
    std::nth_element(first, middle, last, left);
  else
    std::nth_element(first, middle, last, above);
  split_blocks(first, middle, depth - 1);
  split_blocks(middle, last, depth - 1);
}

void SurfaceTemplate::place_points(cv::Point2d origin) {
  x.assign(whole_lanes(size()), kNowhere);
  y = x;
  for (std::size_t i = 0; i < size(); ++i) {
    x[i] = static_cast<float>(sites_[i].at.x - origin.x);
    y[i] = static_cast<float>(sites_[i].at.y - origin.y);
    radius_ = std::max<double>(radius_, std::hypot(x[i], y[i]));
  }
  if (!mixed_) return;
  std::vector<Mixture> mixtures;
  for (const auto& site : sites_) mixtures.push_back(site.mixture);
  unmixing_ = Unmixing(mixtures, origin, padded());
}

void SurfaceTemplate::resize(double factor) {
  for (auto* places : {&x, &y})
    for (auto& place : *places) place *= static_cast<float>(factor);
  radius_ *= factor;
  unmixing_.resize(factor);
}

void SurfaceTemplate::read_colours(const SceneLevel& picture) {
  const ColourSampler colour_at(picture.colour);
  const auto right = static_cast<float>(picture.size().width) - 1.02f;
  const auto bottom = static_cast<float>(picture.size().height) - 1.02f;
  for (auto* values : {&planes[0], &planes[1], &planes[2], &energy}) values->assign(padded(), 0.f);
  std::vector<float> ones(padded(), 0.f);
  for (std::size_t i = 0; i < size(); ++i) {
    float colour[kChannels] = {};
    colour_at(std::clamp(sites_[i].at.x, 0.f, right), std::clamp(sites_[i].at.y, 0.f, bottom),
              colour);
    for (int c = 0; c < kChannels; ++c) {
      planes[c][i] = colour[c];
      energy[i] += colour[c] * colour[c];
    }
    ones[i] = 1;
  }
  histogram = chroma_histogram(planes, ones);
}

void SurfaceTemplate::read_unmixed_colours(const SceneLevel& picture, cv::Point2d origin) {
  SurfaceSample own;
  const Pose2D home{origin.x, origin.y, 0};
  picture.prepare_around(home, radius_);
  sample(picture, home, own);
  planes = own.planes;
  energy.assign(padded(), 0.f);
  for (const auto& plane : planes)
    for (std::size_t i = 0; i < padded(); ++i) energy[i] += plane[i] * plane[i];
  histogram = chroma_histogram(planes, own.inside);
}

void SurfaceTemplate::measure_texture() {
  constexpr double kPlain = 200;  // [grey^2] variance that noise and shading alone bring about
  const auto count = static_cast<double>(std::max<std::size_t>(1, size()));
  double variance = 0;
  for (const auto& plane : planes) {
    const double mean = std::accumulate(plane.begin(), plane.end(), 0.0) / count;
    variance += (product(plane, plane.data()) / count - mean * mean) / kChannels;
  }
  texture_ = variance / (variance + kPlain);
}

void SurfaceTemplate::read_gradients(const SceneLevel& picture) {
  constexpr float kNoise = 2.5f;  // [grey levels per pixel]
  gradient_x.assign(padded(), 0.f);
  gradient_y.assign(padded(), 0.f);
  const cv::Mat gradients = strongest_gradient(picture.colour);
  for (std::size_t i = 0; i < size(); ++i) {
    const Site& site = sites_[i];
    if (site.depth <= 2.5f) continue;
    const int column = std::clamp(cvRound(site.at.x), 0, picture.size().width - 1);
    const int row = std::clamp(cvRound(site.at.y), 0, picture.size().height - 1);
    const auto gradient = gradients.at<cv::Vec2s>(row, column);
    const float gx = gradient[0] / 8.f, gy = gradient[1] / 8.f;
    const float square = gx * gx + gy * gy + 1e-6f;
    const float weight = std::max(0.f, std::sqrt(square) - kNoise);
    gradient_x[i] = weight * (gx * gx - gy * gy) / square;
    gradient_y[i] = weight * 2 * gx * gy / square;
    gradient_total += weight;
  }
}

void SurfaceTemplate::build_basis() {
  const int wanted = size() >= 150 ? kMaxBasis : size() >= 60 ? 6 : 3;
  for (int k = 0; k < wanted; ++k) {
    std::vector<float> row(padded(), 0.f);
    for (std::size_t i = 0; i < size(); ++i) {
      const float u = x[i] / static_cast<float>(radius_), v = y[i] / static_cast<float>(radius_);
      const Site& site = sites_[i];
      const float rim = std::exp(-site.depth / 1.5f), bevel = std::exp(-site.depth / 4.f);
      const float functions[kMaxBasis] = {1,
                                          u,
                                          v,
                                          bevel * site.inward.x,
                                          bevel * site.inward.y,
                                          bevel,
                                          rim * site.inward.x,
                                          rim * site.inward.y,
                                          rim,
                                          u * u,
                                          u * v,
                                          v * v};
      row[i] = functions[k];
    }
    const double before = product(row, row.data());
    for (int pass = 0; pass < 2; ++pass)
      for (int j = 0; j < basis_size; ++j) {
        const float* other = &basis[j * padded()];
        subtract(row, product(row, other), other);
      }
    const double after = product(row, row.data());
    if (after < 1e-3 * before || after < 1e-9) continue;
    for (auto& value : row) value /= static_cast<float>(std::sqrt(after));
    basis.insert(basis.end(), row.begin(), row.end());
    ++basis_size;
  }
}

void SurfaceTemplate::project() {
  for (int c = 0; c < kChannels; ++c) {
    projected[c] = planes[c];
    for (int j = 0; j < basis_size; ++j) {
      const float* row = &basis[j * padded()];
      subtract(projected[c], product(projected[c], row), row);
    }
    projected_energy += product(projected[c], projected[c].data());
  }
}

void SurfaceTemplate::read_slopes(const SceneLevel& picture) {
  const ColourSampler colour_at(picture.colour);
  std::array<std::array<std::vector<float>, 3>, 3> rows;  // [channel][parameter]
  for (auto& channel : rows)
    for (auto& row : channel) row.assign(padded(), 0.f);
  for (std::size_t i = 0; i < size(); ++i) {
    float low_x[3], high_x[3], low_y[3], high_y[3];
    const cv::Point2f at = sites_[i].at;
    if (!colour_at(at.x - 1, at.y, low_x) || !colour_at(at.x + 1, at.y, high_x) ||
        !colour_at(at.x, at.y - 1, low_y) || !colour_at(at.x, at.y + 1, high_y))
      continue;
    for (int c = 0; c < kChannels; ++c) {
      const float along_x = (high_x[c] - low_x[c]) / 2, along_y = (high_y[c] - low_y[c]) / 2;
      rows[c][0][i] = along_x;
      rows[c][1][i] = along_y;
      rows[c][2][i] = along_y * x[i] - along_x * y[i];
    }
  }
  for (auto& channel : rows)
    for (auto& row : channel)
      for (int j = 0; j < basis_size; ++j) {
        const float* other = &basis[j * padded()];
        subtract(row, product(row, other), other);
      }
  for (int k = 0; k < 3; ++k) {
    double along = 0;
    for (int c = 0; c < kChannels; ++c) along += product(rows[c][k], projected[c].data());
    for (int c = 0; c < kChannels; ++c)
      subtract(rows[c][k], along / (projected_energy + 1e-6), projected[c].data());
  }
  for (int c = 0; c < kChannels; ++c) {
    for (const auto& row : rows[c]) slopes[c].insert(slopes[c].end(), row.begin(), row.end());
    slopes[c].insert(slopes[c].end(), projected[c].begin(), projected[c].end());
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) slope_product(j, k) += product(rows[c][j], rows[c][k].data());
  }
}

}  // namespace mbncc
