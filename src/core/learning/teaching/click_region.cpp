// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/click_region.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <vector>

namespace mbncc {
namespace {

constexpr int kWidth = 240;        // [px] that distances are measured at
constexpr float kStepCost = 0.5F;  // [grey levels / px] of even colour
constexpr int kTouch = 2;          // [px] radius of the click
constexpr int kGap = 9;            // [px] pieces nearer than this are joined

constexpr double kMissed = 15;  // [px] largest distance of a click to its patch

using Step = std::pair<float, int>;  // distance, pixel

float colour_step(const cv::Vec3f& a, const cv::Vec3f& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

// Geodesic distance from the pixels of `seeds` (Dijkstra).
cv::Mat colour_distance(const cv::Mat& picture, const cv::Mat& seeds) {
  cv::Mat distance(picture.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::max()));
  distance.setTo(0, seeds);
  std::priority_queue<Step, std::vector<Step>, std::greater<>> open;
  for (int i = 0; i < static_cast<int>(seeds.total()); ++i)
    if (seeds.at<uchar>(i / seeds.cols, i % seeds.cols)) open.emplace(0.F, i);
  const cv::Rect room({0, 0}, picture.size());
  while (!open.empty()) {
    const auto [so_far, pixel] = open.top();
    open.pop();
    const cv::Point at(pixel % picture.cols, pixel / picture.cols);
    if (so_far > distance.at<float>(at)) continue;
    for (const cv::Point& way :
         {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point next = at + way;
      if (!room.contains(next)) continue;
      const float there =
          so_far + kStepCost + colour_step(picture.at<cv::Vec3f>(at), picture.at<cv::Vec3f>(next));
      if (there >= distance.at<float>(next)) continue;
      distance.at<float>(next) = there;
      open.emplace(there, next.y * picture.cols + next.x);
    }
  }
  return distance;
}

}  // namespace

cv::Mat grow_from_click(const cv::Mat& picture, const cv::Point2d& click) {
  const double scale = std::min(1.0, static_cast<double>(kWidth) / picture.cols);
  cv::Mat small, smooth, near;
  cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
  cv::medianBlur(small, small, 3);
  small.convertTo(smooth, CV_32F);
  cv::Mat touched = cv::Mat::zeros(small.size(), CV_8UC1), border = touched.clone();
  cv::circle(touched, cv::Point(cvFloor(click.x * scale), cvFloor(click.y * scale)), kTouch,
             cv::Scalar(255), cv::FILLED);
  cv::rectangle(border, cv::Rect({0, 0}, small.size()), cv::Scalar(255));
  border.setTo(0, touched);
  const cv::Mat object = colour_distance(smooth, touched) < colour_distance(smooth, border);
  cv::resize(object, near, picture.size(), 0, 0, cv::INTER_NEAREST);
  return near;
}

cv::Mat piece_at(const cv::Mat& mask, const cv::Point2d& click) {
  cv::Mat labels;
  cv::connectedComponents(mask, labels, 8, CV_32S);
  double nearest = kMissed;
  int chosen = 0;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const double distance = std::hypot(x - click.x, y - click.y);
      if (labels.at<int>(y, x) == 0 || distance >= nearest) continue;
      nearest = distance;
      chosen = labels.at<int>(y, x);
    }
  if (chosen == 0) return cv::Mat::zeros(mask.size(), CV_8UC1);
  return labels == chosen;
}

cv::Mat change_at_click(const cv::Mat& changed, const cv::Point2d& click) {
  cv::Mat joined;
  cv::morphologyEx(changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  return changed & piece_at(joined, click);
}

}  // namespace mbncc
