// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/map_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc::templates {
namespace {

constexpr float kTiny = 1e-6f;
constexpr int kBorder = 8;  // [px] room around the map, so that its edge has an outside

cv::Mat bordered(const cv::Mat& map) {
  cv::Mat wide;
  cv::copyMakeBorder(map, wide, kBorder, kBorder, kBorder, kBorder, cv::BORDER_CONSTANT,
                     cv::Scalar(0));
  return wide;
}

cv::Point2f unit(float x, float y) {
  const float length = std::hypot(x, y) + kTiny;
  return {x / length, y / length};
}

/// Normal of a contour at its pixel `i` from the contour's direction, for maps too thin for a
/// gradient: findContours() keeps the outside on the same side, and turns back at the end of a
/// line.
cv::Point2f normal_of_course(const std::vector<cv::Point>& contour, std::size_t i) {
  const std::size_t count = contour.size();
  const cv::Point before = contour[(i + count - 1) % count], after = contour[(i + 1) % count];
  const cv::Point along = after - before, ahead = contour[i] - before;
  if (along != cv::Point()) return unit(static_cast<float>(-along.y), static_cast<float>(along.x));
  if (ahead != cv::Point()) return unit(static_cast<float>(ahead.x), static_cast<float>(ahead.y));
  return {0, 1};  // of a single pixel
}

struct Spread {
  cv::Mat colour;  // CV_8UC3
  cv::Mat weight;  // CV_32FC1
};

cv::Mat smoothed(const cv::Mat& values, double reach) {
  cv::Mat result;
  cv::GaussianBlur(values, result, {}, reach);
  return result;
}

// Mean colour of the surface about each pixel. Wide averages are smooth and computed on fewer
// pixels.
Spread spread_out(const cv::Mat& surface, const cv::Mat& weight, double reach) {
  if (reach > 4) {
    cv::Mat small_surface, small_weight;
    const cv::Size half((surface.cols + 1) / 2, (surface.rows + 1) / 2);
    cv::resize(surface, small_surface, half, 0, 0, cv::INTER_AREA);
    cv::resize(weight, small_weight, half, 0, 0, cv::INTER_AREA);
    Spread spread = spread_out(small_surface, small_weight, reach / 2);
    cv::resize(spread.colour, spread.colour, surface.size(), 0, 0, cv::INTER_LINEAR);
    cv::resize(spread.weight, spread.weight, surface.size(), 0, 0, cv::INTER_LINEAR);
    return spread;
  }
  Spread spread{{}, smoothed(weight, reach)};
  cv::Mat total;
  cv::cvtColor(cv::max(spread.weight, kTiny), total, cv::COLOR_GRAY2BGR);
  const cv::Mat colour = smoothed(surface, reach) / total;
  colour.convertTo(spread.colour, CV_8U);
  return spread;
}

}  // namespace

MapGeometry::MapGeometry(const cv::Mat& map) : map_(bordered(map)) {
  cv::Mat depth, smooth;
  cv::distanceTransform(map_, depth, cv::DIST_L2, cv::DIST_MASK_5);
  cv::GaussianBlur(depth, smooth, {}, 1.5);
  const cv::Rect inner({kBorder, kBorder}, map.size());
  depth_ = depth(inner).clone();
  cv::Mat slope_x, slope_y;
  cv::Sobel(smooth, slope_x, CV_32F, 1, 0);
  cv::Sobel(smooth, slope_y, CV_32F, 0, 1);
  slope_x_ = slope_x(inner).clone();
  slope_y_ = slope_y(inner).clone();
  mean_width_ = 2 * cv::countNonZero(map_) / std::max(1.0, static_cast<double>(edge(1.5).size()));
}

cv::Point2f MapGeometry::inward(cv::Point pixel) const {
  return unit(slope_x_.at<float>(pixel), slope_y_.at<float>(pixel));
}

std::vector<EdgePoint> MapGeometry::edge(double smoothing) const {
  cv::Mat soft, slope_x, slope_y;
  map_.convertTo(soft, CV_32F, 1.0 / 255);
  cv::GaussianBlur(soft, soft, {}, smoothing);
  cv::Sobel(soft, slope_x, CV_32F, 1, 0);
  cv::Sobel(soft, slope_y, CV_32F, 0, 1);
  // RETR_CCOMP follows a hole along the map pixels around it, so every point is a map pixel.
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(map_.clone(), contours, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  std::vector<EdgePoint> points;
  for (const auto& contour : contours) {
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const cv::Point pixel = contour[i];
      const float x = -slope_x.at<float>(pixel), y = -slope_y.at<float>(pixel);
      const cv::Point2f normal =
          std::hypot(x, y) < 1e-3f ? normal_of_course(contour, i) : unit(x, y);
      const cv::Point2f corner(static_cast<float>(kBorder), static_cast<float>(kBorder));
      points.push_back({cv::Point2f(pixel) - corner + 0.5f * normal, normal});
    }
  }
  return points;
}

cv::Mat continued_outwards(const cv::Mat& image, const cv::Mat& map) {
  cv::Mat weight, surface, result = image.clone();
  map.convertTo(weight, CV_32F, 1.0 / 255);
  image.copyTo(surface, map);
  surface.convertTo(surface, CV_32F);
  result.setTo(cv::mean(image, map), map == 0);
  // From far to near, so that the nearest surface overwrites others.
  for (const double reach : {12.0, 5.0, 2.0}) {
    const Spread spread = spread_out(surface, weight, reach);
    spread.colour.copyTo(result, (spread.weight > 0.02) & (map == 0));
  }
  return result;
}

}  // namespace mbncc::templates
