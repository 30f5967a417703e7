// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/template_bank.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "imaging/pyramid.hpp"
#include "matching/template/map_level.hpp"
#include "mbncc/geometry.hpp"
#include "simd/kernels.hpp"

namespace mbncc::proposal {
namespace {

constexpr int kTopLevel = 5;
constexpr int kMinPixels = 36;  // fewer pixels match by chance everywhere, ...
constexpr int kFewPixels = 14;  // ... but suffice from kFineLevel on: finer levels are slow
constexpr int kFineLevel = 2;
constexpr int kMostRadius = 256;   // [px] of the rotated template: limits its memory
constexpr float kCoverage = 0.6f;  // [0..1] least part of a pixel inside the map
constexpr double kArcStep = 2.6;   // [px] that the rim moves per rotation step
constexpr int kOversampling = 4;   // samples per pixel side when rotating
constexpr int kWhole = 65;         // [px] larger images are rotated ...
constexpr int kTile = 16;          // [px] ... in tiles of this side, where the template is

/// Template and map at a level finer than the coarse one, for rotation.
struct Source {
  cv::Mat coverage;  // CV_32FC1, of the map
  cv::Mat both;      // CV_32FC2, coverage and the template's values weighted by it
  cv::Point2d anchor;
  int samples;  // per coarse pixel side
};

Source turning_source(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor, int level) {
  const int finer = std::min(level, static_cast<int>(std::log2(kOversampling)));
  const templates::MapLevel source = templates::map_level(grey, map, level - finer);
  cv::Mat both;
  cv::merge(std::vector<cv::Mat>{source.coverage, source.values.mul(source.coverage)}, both);
  return {source.coverage, both, imaging::to_level(anchor, level - finer), 1 << finer};
}

/// Whether samples of the fine pixels in `tile` may lie in an image of `size`.
bool may_touch(const cv::Matx23d& to_source, const cv::Rect& tile, cv::Size size) {
  const cv::Point2d middle = 0.5 * cv::Point2d(tile.tl() + tile.br());
  const cv::Vec2d at = to_source * cv::Vec3d(middle.x, middle.y, 1);
  const double reach = 1 + std::hypot(tile.width, tile.height) / 2;
  return at[0] > -reach && at[1] > -reach && at[0] < size.width + reach &&
         at[1] < size.height + reach;
}

/// `image` rotated about its anchor and averaged down to (2 radius + 1)^2 coarse pixels.
cv::Mat turned(const cv::Mat& image, const Source& source, double angle, int radius) {
  const int side = 2 * radius + 1, tile = side > kWhole ? kTile : side;
  const double middle = 0.5 * (side * source.samples - 1);
  const double c = std::cos(angle), s = std::sin(angle);
  const cv::Matx23d to_source(c, s, source.anchor.x - c * middle - s * middle,  //
                              -s, c, source.anchor.y + s * middle - c * middle);
  cv::Mat coarse = cv::Mat::zeros(side, side, image.type()), fine;
  for (int y = 0; y < side; y += tile)
    for (int x = 0; x < side; x += tile) {
      cv::Mat part = coarse(cv::Rect(x, y, tile, tile) & cv::Rect({0, 0}, coarse.size()));
      const cv::Rect samples(source.samples * cv::Point(x, y), part.size() * source.samples);
      if (!may_touch(to_source, samples, image.size())) continue;
      cv::Matx23d from_tile = to_source;
      from_tile(0, 2) += c * samples.x + s * samples.y;
      from_tile(1, 2) += c * samples.y - s * samples.x;
      cv::warpAffine(image, fine, from_tile, samples.size(),
                     cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar(0));
      cv::resize(fine, part, part.size(), 0, 0, cv::INTER_AREA);
    }
  return coarse;
}

/// Rounds to weights of at most kMaxWeight and corrects the rounding error, so that the sum is
/// exactly 0 and the image's mean cancels.
std::vector<std::int16_t> zero_sum_weights(const std::vector<float>& values) {
  double mean = 0;
  for (float value : values) mean += value / static_cast<double>(values.size());
  double largest = 1e-3;
  for (float value : values) largest = std::max(largest, std::abs(value - mean));
  std::vector<std::int16_t> weights;
  int sum = 0;
  for (float value : values) {
    weights.push_back(
        static_cast<std::int16_t>(std::lround((value - mean) * kernels::kMaxWeight / largest)));
    sum += weights.back();
  }
  const int correction = sum > 0 ? -1 : 1;
  for (std::size_t i = 0; sum != 0; i = (i + 1) % weights.size()) {
    if (std::abs(weights[i] + correction) > kernels::kMaxWeight) continue;
    weights[i] = static_cast<std::int16_t>(weights[i] + correction);
    sum += correction;
  }
  return weights;
}

void add_pixel(RotatedKernel& kernel, int x, int y) {
  if (!kernel.runs.empty() && kernel.runs.back().y == y && kernel.runs.back().end == x)
    ++kernel.runs.back().end;
  else
    kernel.runs.push_back({y, x, x + 1});
  kernel.pixels.emplace_back(x, y);
}

RotatedKernel rotated_kernel(const Source& source, double angle, int radius) {
  const cv::Mat both = turned(source.both, source, angle, radius);
  RotatedKernel kernel;
  kernel.angle = angle;
  std::vector<float> values;
  for (int y = 0; y < both.rows; ++y) {
    for (int x = 0; x < both.cols; ++x) {
      const auto& [covered, weighted] = both.at<cv::Vec2f>(y, x).val;
      if (covered < kCoverage) continue;
      add_pixel(kernel, x - radius, y - radius);
      values.push_back(weighted / covered);
    }
  }
  if (values.empty()) return kernel;
  kernel.weights = zero_sum_weights(values);
  double square = 0;
  for (int weight : kernel.weights) square += weight * weight;
  kernel.norm = std::sqrt(square);
  return kernel;
}

int fewest_pixels(const Source& source, int radius) {
  constexpr int kTrials = 6;
  int fewest = std::numeric_limits<int>::max();
  for (int k = 0; k < kTrials; ++k) {
    const cv::Mat coverage = turned(source.coverage, source, k * kPi / kTrials, radius);
    fewest = std::min(fewest, cv::countNonZero(coverage >= kCoverage));
  }
  return fewest;
}

RotatedKernel turned_map(const Source& source, double angle, int radius) {
  constexpr float kHalf = 0.5f, kQuarter = 0.25f;
  const cv::Mat coverage = turned(source.coverage, source, angle, radius);
  const bool narrow = cv::countNonZero(coverage >= kHalf) < kHalf * cv::sum(coverage)[0];
  RotatedKernel kernel;
  kernel.angle = angle;
  for (int y = 0; y < coverage.rows; ++y)
    for (int x = 0; x < coverage.cols; ++x)
      if (coverage.at<float>(y, x) >= (narrow ? kQuarter : kHalf))
        add_pixel(kernel, x - radius, y - radius);
  return kernel;
}

/// Kernels at `count` rotations, evenly spaced over a turn.
numeric::Lazy<std::vector<RotatedKernel>> turned_by(RotatedKernel (*turn)(const Source&, double,
                                                                          int),
                                                    const Source& source, int radius, int count) {
  return numeric::Lazy<std::vector<RotatedKernel>>([=] {
    std::vector<RotatedKernel> kernels;
    for (int k = 0; k < count; ++k) kernels.push_back(turn(source, 2 * kPi * k / count, radius));
    return kernels;
  });
}

}  // namespace

TemplateBank rotated_kernels(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor) {
  const double farthest = farthest_pixel(map, anchor);
  TemplateBank bank;
  Source source;
  for (bank.level = kTopLevel; bank.level >= 0; --bank.level) {
    bank.radius = static_cast<int>(std::ceil(farthest / (1 << bank.level))) + 1;
    if (bank.radius > kMostRadius) return {};
    source = turning_source(grey, map, anchor, bank.level);
    const int enough = bank.level > kFineLevel ? kMinPixels : kFewPixels;
    if (bank.level == 0 || fewest_pixels(source, bank.radius) >= enough) break;
  }
  const double rim = 2 * kPi * farthest / (1 << bank.level);
  const int rotations = std::max(12, static_cast<int>(std::ceil(rim / kArcStep)));
  bank.kernels = turned_by(rotated_kernel, source, bank.radius, rotations);
  return bank;
}

TemplateBank turned_maps(const cv::Mat& map, cv::Point2d anchor, int level, int count) {
  TemplateBank bank;
  bank.level = level;
  bank.radius = static_cast<int>(std::ceil(farthest_pixel(map, anchor) / (1 << level))) + 1;
  const Source source = turning_source(map, map, anchor, level);
  bank.kernels = turned_by(turned_map, source, bank.radius, count);
  return bank;
}

}  // namespace mbncc::proposal
