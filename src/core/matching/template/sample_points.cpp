// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/sample_points.hpp"

#include <algorithm>
#include <random>

#include "imaging/pyramid.hpp"

namespace mbncc::templates {
namespace {

using Points = std::vector<SurfacePoint>;

cv::Point2f at_level(cv::Point2f place, int level) {
  return cv::Point2f(imaging::to_level(cv::Point2d(place), level));
}

/// Centres of the level's pixels that lie deeper than `depth` [px at level 0] in the map.
std::vector<cv::Point> pixels_deeper_than(double depth, const MapGeometry& map, cv::Size size,
                                          int level) {
  const int side = 1 << level;
  std::vector<cv::Point> pixels;
  // Maps narrower than a pixel of the level are sampled in their middle.
  const cv::Point first(std::min(side, size.width - 1) / 2, std::min(side, size.height - 1) / 2);
  for (int y = first.y; y < size.height; y += side)
    for (int x = first.x; x < size.width; x += side)
      if (map.depth({x, y}) > depth) pixels.emplace_back(x, y);
  return pixels;
}

/// Points away from the edge, which show only the object.
std::vector<cv::Point> pure_pixels(const MapGeometry& map, cv::Size size, int level) {
  return pixels_deeper_than(level == 0 ? 1.9 : 0.5 + 0.75 * (1 << level), map, size, level);
}

Points points_of(const MapGeometry& map, const std::vector<cv::Point>& pixels, int level) {
  Points points;
  points.reserve(pixels.size());
  for (const auto& pixel : pixels)
    points.push_back({at_level(cv::Point2f(pixel), level), map.depth(pixel), map.inward(pixel)});
  return points;
}

/// Keeps at most `most` random points, and frees the excess memory.
template <class Point>
void thin_out(std::vector<Point>& points, std::size_t most) {
  std::mt19937 random(5);
  for (std::size_t i = 0; i + 1 < points.size() && i < most; ++i)
    std::swap(points[i], points[i + random() % (points.size() - i)]);
  if (points.size() > most)
    points = {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(most)};
}

/// Halves the points along their longer side, `depth` times.
void split_blocks(SamplePoints& all, Points::iterator first, Points::iterator last, int depth) {
  if (depth == 0) {
    all.block_ends.push_back(static_cast<int>(last - all.points.begin()));
    return;
  }
  const auto left = [](const SurfacePoint& a, const SurfacePoint& b) { return a.at.x < b.at.x; };
  const auto above = [](const SurfacePoint& a, const SurfacePoint& b) { return a.at.y < b.at.y; };
  const auto [west, east] = std::minmax_element(first, last, left);
  const auto [north, south] = std::minmax_element(first, last, above);
  const auto middle = first + (last - first) / 2;
  if (east->at.x - west->at.x > south->at.y - north->at.y)
    std::nth_element(first, middle, last, left);
  else
    std::nth_element(first, middle, last, above);
  split_blocks(all, first, middle, depth - 1);
  split_blocks(all, middle, last, depth - 1);
}

}  // namespace

SamplePoints choose_surface_points(const MapGeometry& map, cv::Size size, int level,
                                   std::size_t most) {
  const std::size_t enough = level == 0 ? 100 : 40;
  auto pixels = pure_pixels(map, size, level);
  if (pixels.size() < enough) pixels = pixels_deeper_than(0, map, size, level);
  thin_out(pixels, most);
  SamplePoints chosen;
  chosen.points = points_of(map, pixels, level);
  const std::size_t count = chosen.points.size();
  const int depth = count >= 96 ? 3 : count >= 48 ? 2 : count >= 24 ? 1 : 0;
  split_blocks(chosen, chosen.points.begin(), chosen.points.end(), depth);
  return chosen;
}

}  // namespace mbncc::templates
