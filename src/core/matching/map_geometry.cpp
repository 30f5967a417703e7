#include "matching/map_geometry.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc {
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
}

cv::Point2f MapGeometry::inward(cv::Point pixel) const {
  return unit(slope_x_.at<float>(pixel), slope_y_.at<float>(pixel));
}

double MapGeometry::mean_width() const {
  const double length = static_cast<double>(edge(1.5).size());
  return 2 * cv::countNonZero(map_) / std::max(1.0, length);
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
    for (const auto& pixel : contour) {
      const float x = -slope_x.at<float>(pixel), y = -slope_y.at<float>(pixel);
      if (std::hypot(x, y) < 1e-3f) continue;
      const cv::Point2f normal = unit(x, y);
      const cv::Point2f corner(static_cast<float>(kBorder), static_cast<float>(kBorder));
      points.push_back({cv::Point2f(pixel) - corner + 0.5f * normal, normal});
    }
  }
  return points;
}

cv::Mat continued_outwards(const cv::Mat& picture, const cv::Mat& map) {
  cv::Mat weight, known, result = picture.clone();
  map.convertTo(weight, CV_32F, 1.0 / 255);
  cv::Mat weights, surface;
  cv::merge(std::vector<cv::Mat>{weight, weight, weight}, weights);
  picture.convertTo(surface, CV_32F);
  surface = surface.mul(weights);
  result.setTo(cv::mean(picture, map), map == 0);
  // From far to near, so that the nearest surface has the last word.
  for (const double reach : {12.0, 5.0, 2.0}) {
    cv::Mat spread, total;
    cv::GaussianBlur(surface, spread, {}, reach);
    cv::GaussianBlur(weights, total, {}, reach);
    cv::Mat continued = spread / cv::max(total, kTiny), rounded, near;
    continued.convertTo(rounded, CV_8U);
    cv::extractChannel(total, near, 0);
    rounded.copyTo(result, (near > 0.02) & (map == 0));
  }
  return result;
}

}  // namespace mbncc
