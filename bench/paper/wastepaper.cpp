// SPDX-License-Identifier: BSD-3-Clause
#include "paper/wastepaper.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::bench {
namespace {

constexpr int kCorners = 13;
constexpr double kBrightest = 245, kDarkest = 165;  // [grey levels] of the facets

std::vector<cv::Point2d> rim(cv::Point2d centre, double radius, cv::RNG& random) {
  std::vector<cv::Point2d> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * kPi * (i + random.uniform(-0.3, 0.3)) / kCorners;
    const double reach = radius * random.uniform(0.75, 1.0);
    corners.push_back(centre + reach * cv::Point2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

}  // namespace

void draw_wastepaper(cv::Mat& image, cv::Point2d centre, double diameter, std::uint64_t seed) {
  cv::RNG random(seed);
  const auto outer = rim(centre, diameter / 2, random);
  const auto inner = rim(centre, diameter / 4, random);
  const auto facet = [&](cv::Point2d a, cv::Point2d b, cv::Point2d c) {
    const std::vector<cv::Point> corners{a, b, c};
    cv::fillConvexPoly(image, corners, cv::Scalar::all(random.uniform(kDarkest, kBrightest)),
                       cv::LINE_AA);
  };
  for (int i = 0; i < kCorners; ++i) {
    const int next = (i + 1) % kCorners;
    facet(outer[i], outer[next], inner[i]);
    facet(inner[i], inner[next], outer[next]);
    facet(inner[i], inner[next], centre);
  }
}

}  // namespace mbncc::bench
