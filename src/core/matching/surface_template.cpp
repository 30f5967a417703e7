#include "matching/surface_template.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "matching/padded_vectors.hpp"
#include "matching/sampling.hpp"
#include "mbncc/matching/pyramid.hpp"
#include "polar/kernels.hpp"

namespace mbncc {
namespace {

constexpr float kDark = 12;  // [grey levels] added before logarithms

std::size_t whole_lanes(std::size_t count) {
  return (count + kernels::kLanes - 1) / kernels::kLanes * kernels::kLanes;
}

/// Halves a set of points along its longer side, `depth` times.
void split(std::vector<int>& order, int begin, int end, const std::vector<float>& x,
           const std::vector<float>& y, int depth, std::vector<int>& block, int& blocks) {
  if (depth == 0) {
    for (int i = begin; i < end; ++i) block[order[i]] = blocks;
    ++blocks;
    return;
  }
  const auto extent = [&](const std::vector<float>& values) {
    const auto less = [&](int a, int b) { return values[a] < values[b]; };
    const auto ends = std::minmax_element(order.begin() + begin, order.begin() + end, less);
    return values[*ends.second] - values[*ends.first];
  };
  const std::vector<float>& along = extent(x) > extent(y) ? x : y;
  const int middle = (begin + end) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end,
                   [&](int a, int b) { return along[a] < along[b]; });
  split(order, begin, middle, x, y, depth - 1, block, blocks);
  split(order, middle, end, x, y, depth - 1, block, blocks);
}

}  // namespace

cv::Point2f chroma(float blue, float green, float red) {
  const float reference = std::log(green + kDark);
  return {std::log(red + kDark) - reference, std::log(blue + kDark) - reference};
}

int chroma_cell(cv::Point2f chroma) {
  constexpr float kReach = 0.6f;
  const auto cell = [](float value) {
    const float scaled = (value + kReach) * SurfaceTemplate::kHistogramSide / (2 * kReach);
    return std::clamp(static_cast<int>(std::floor(scaled)), 0, SurfaceTemplate::kHistogramSide - 1);
  };
  return cell(chroma.x) * SurfaceTemplate::kHistogramSide + cell(chroma.y);
}

SurfaceTemplate::SurfaceTemplate(const SceneLevel& picture, const MapGeometry& map,
                                 cv::Size map_size, cv::Point2d anchor, int level,
                                 std::size_t most) {
  choose_points(map, map_size, anchor, level, most);
  for (auto& plane : planes) plane.assign(whole_lanes(size()), 0.f);
  const ColourSampler colour_at(picture.colour);
  for (std::size_t i = 0; i < size(); ++i) {
    float colour[3] = {};
    const auto right = static_cast<float>(picture.size().width) - 1.02f;
    const auto bottom = static_cast<float>(picture.size().height) - 1.02f;
    colour_at(std::clamp(sites_[i].at.x, 0.f, right), std::clamp(sites_[i].at.y, 0.f, bottom),
              colour);
    for (int c = 0; c < kChannels; ++c) planes[c][i] = colour[c];
  }
  read_gradients(picture);
  count_chroma();
  build_basis();
  project();
  read_slopes(picture);
  split_blocks();
}

void SurfaceTemplate::choose_points(const MapGeometry& map, cv::Size map_size, cv::Point2d anchor,
                                    int level, std::size_t most) {
  const int side = 1 << level;
  const std::size_t enough = level == 0 ? 100 : 40;
  // Away from the edge, where picture pixels mix with the background; thin maps come nearer.
  double need = level == 0 ? 1.9 : 0.5 + 0.75 * side;
  for (int attempt = 0; attempt < 4; ++attempt) {
    sites_.clear();
    for (int y = side / 2; y < map_size.height; y += side) {
      for (int x = side / 2; x < map_size.width; x += side) {
        const float depth = map.depth({x, y});
        if (depth <= 0 || depth <= need) continue;
        sites_.push_back(
            {cv::Point2f(to_level(cv::Point2d(x, y), level)), depth, map.inward({x, y})});
      }
    }
    if (sites_.size() >= enough) break;
    need = attempt == 2 ? 0 : 0.65 * need;
  }
  std::mt19937 random(5);
  for (std::size_t i = 0; i + 1 < sites_.size() && i < most; ++i)
    std::swap(sites_[i], sites_[i + random() % (sites_.size() - i)]);
  if (sites_.size() > most) sites_.resize(most);
  const cv::Point2d origin = to_level(anchor, level);
  for (const auto& site : sites_) {
    x.push_back(static_cast<float>(site.at.x - origin.x));
    y.push_back(static_cast<float>(site.at.y - origin.y));
    radius_ = std::max<double>(radius_, std::hypot(x.back(), y.back()));
  }
}

void SurfaceTemplate::read_gradients(const SceneLevel& picture) {
  constexpr float kNoise = 2.5f;  // [grey levels per pixel]
  for (const auto& site : sites_) {
    const int column = std::clamp(cvRound(site.at.x), 0, picture.size().width - 1);
    const int row = std::clamp(cvRound(site.at.y), 0, picture.size().height - 1);
    const auto gradient = picture.gradient.at<cv::Vec2s>(row, column);
    const float gx = gradient[0] / 8.f, gy = gradient[1] / 8.f;
    const float square = gx * gx + gy * gy + 1e-6f;
    const bool interior = site.depth > 2.5f;
    gradient_weight.push_back(interior ? std::max(0.f, std::sqrt(square) - kNoise) : 0.f);
    gradient_x.push_back((gx * gx - gy * gy) / square);
    gradient_y.push_back(2 * gx * gy / square);
    gradient_total += gradient_weight.back();
  }
}

void SurfaceTemplate::count_chroma() {
  const float share = 1 / static_cast<float>(std::max<std::size_t>(1, size()));
  for (std::size_t i = 0; i < size(); ++i)
    histogram[chroma_cell(chroma(planes[0][i], planes[1][i], planes[2][i]))] += share;
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

void SurfaceTemplate::split_blocks() {
  block.assign(size(), 0);
  const int depth = size() >= 240 ? 3 : size() >= 100 ? 2 : size() >= 50 ? 1 : 0;
  std::vector<int> order(size());
  std::iota(order.begin(), order.end(), 0);
  blocks = 0;
  split(order, 0, static_cast<int>(size()), x, y, depth, block, blocks);
}

}  // namespace mbncc
