// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/map_footprint.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc::templates {

MapFootprint::MapFootprint(const cv::Mat& map, cv::Point2d anchor) : map_(map), anchor_(anchor) {
  constexpr std::size_t kSamples = 400;
  std::vector<cv::Point> pixels;
  cv::findNonZero(map, pixels);
  area_ = static_cast<double>(pixels.size());
  const std::size_t step = std::max<std::size_t>(1, pixels.size() / kSamples);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const cv::Point2d point = cv::Point2d(pixels[i]) - anchor;
    radius_ = std::max(radius_, cv::norm(point));
    if (i % step == 0) sample_.push_back(point);
  }
}

bool MapFootprint::covers(cv::Point2d point) const {
  const cv::Point pixel(static_cast<int>(std::lround(point.x + anchor_.x)),
                        static_cast<int>(std::lround(point.y + anchor_.y)));
  return cv::Rect({0, 0}, map_.size()).contains(pixel) && map_.at<uchar>(pixel) != 0;
}

double overlap(const MapFootprint& a, const Pose2D& pose_a, const MapFootprint& b,
               const Pose2D& pose_b) {
  if (a.area() > b.area()) return overlap(b, pose_b, a, pose_a);
  if (cv::norm(pose_a.position() - pose_b.position()) > a.radius() + b.radius()) return 0;
  const Transform a_in_b(compose(inverse(pose_b), pose_a));
  const auto common = std::count_if(a.sample_.begin(), a.sample_.end(),
                                    [&](cv::Point2d point) { return b.covers(a_in_b(point)); });
  return static_cast<double>(common) / static_cast<double>(a.sample_.size());
}

}  // namespace mbncc::templates
