// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/polar_search.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "imaging/pyramid.hpp"

namespace mbncc {
namespace {

constexpr double kSmallestRadius = 8;    // [px] at the coarsest level
constexpr double kLargestRadius = 2048;  // [px] memory grows with its square
constexpr int kTopLevel = 5;
constexpr double kMinSimilarity = 0.3;   // least similarity of a candidate
constexpr std::size_t kCandidates = 40;  // kept at the coarsest level
constexpr std::size_t kFinal = 16;       // kept at full resolution

Circle circle_of(const cv::Mat& map, PolarRegion region) {
  return region == PolarRegion::kIncircle ? incircle(map) : excircle(map);
}

cv::Mat disc(cv::Size size, const Circle& circle) {
  cv::Mat mask(size, CV_8UC1, cv::Scalar(0));
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (cv::norm(cv::Point2d(x, y) - circle.centre) <= circle.radius + 1)
        mask.at<uchar>(y, x) = 255;
  return mask;
}

/// Pixels of a coarser level that the region covers in full.
cv::Mat region_at(const cv::Mat& region, int level) {
  return imaging::build_pyramid(region, level).back() == 255;
}

void sort_best_first(std::vector<PolarPose>& poses, std::size_t most) {
  std::stable_sort(poses.begin(), poses.end(), [](const PolarPose& a, const PolarPose& b) {
    return a.similarity > b.similarity;
  });
  if (poses.size() > most) poses.resize(most);
}

/// Vertex of the parabola through three equidistant values, in steps from the middle.
double peak_offset(double before, double middle, double after) {
  const double curvature = before - 2 * middle + after;
  return curvature < 0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0;
}

double angle_of(int shift, const PolarGrid& grid) {
  return wrap_angle(2 * kPi * shift / grid.angles);
}

/// Best rotation at `centre` over `count` cyclic shifts from `first` on.
PolarPose best_rotation(const PolarTemplate& object, const cv::Mat& grey, cv::Point2d centre,
                        int first, int count) {
  const auto values = object.similarities(polar_image(grey, centre, object.grid()), first, count);
  const auto best = std::max_element(values.begin(), values.end());
  const int shift = first + static_cast<int>(best - values.begin());
  return {{centre.x, centre.y, angle_of(shift, object.grid())}, *best};
}

}  // namespace

PolarSearch::PolarSearch(const View& view, PolarRegion region) {
  cv::Mat grey;
  cv::cvtColor(view.template_image, grey, cv::COLOR_BGR2GRAY);
  const Circle circle = circle_of(view.map, region);
  if (circle.radius > kLargestRadius)
    throw std::invalid_argument("it is too large for the paper's matching; use the fast engine");
  centre_ = circle.centre;
  const cv::Mat counted = region == PolarRegion::kMap ? view.map : disc(view.map.size(), circle);
  const auto pyramid = imaging::build_pyramid(grey, kTopLevel);
  for (std::size_t level = 0; level < pyramid.size(); ++level) {
    const int l = static_cast<int>(level);
    const double radius = circle.radius / (1 << l);
    if (l > 0 && radius < kSmallestRadius) break;
    templates_.emplace_back(pyramid[level], region_at(counted, l), imaging::to_level(centre_, l),
                            PolarGrid::of(std::max(1.0, radius)));
  }
}

std::vector<PolarPose> PolarSearch::find(const std::vector<cv::Mat>& levels,
                                         const cv::Rect& roi) const {
  const int top = top_level();
  if (static_cast<int>(levels.size()) <= top)
    throw std::invalid_argument("the image's pyramid has too few levels for this object");
  auto poses = scan(levels[top], top, roi);
  for (int level = top - 1; level >= 0; --level)
    for (auto& pose : poses) pose = refined(levels[level], level, pose);
  sort_best_first(poses, kFinal);
  for (auto& pose : poses) pose = interpolated(levels[0], pose);
  return poses;
}

std::vector<PolarPose> PolarSearch::scan(const cv::Mat& grey, int level,
                                         const cv::Rect& roi) const {
  const PolarTemplate& object = templates_[level];
  const cv::Rect area = imaging::to_level(roi, level) & cv::Rect({0, 0}, grey.size());
  if (area.empty()) return {};
  std::vector<PolarPose> best(area.area());
  cv::Mat values(area.size(), CV_64FC1), highest;
  for (int y = 0; y < area.height; ++y)
    for (int x = 0; x < area.width; ++x) {
      auto& pose = best[y * area.width + x];
      pose = best_rotation(object, grey, {double(x + area.x), double(y + area.y)}, 0,
                           object.grid().angles);
      values.at<double>(y, x) = pose.similarity;
    }
  std::vector<PolarPose> peaks;
  cv::dilate(values, highest, cv::Mat());
  for (int i = 0; i < area.area(); ++i)
    if (best[i].similarity >= kMinSimilarity &&
        best[i].similarity >= highest.at<double>(i / area.width, i % area.width))
      peaks.push_back(best[i]);
  sort_best_first(peaks, kCandidates);
  return peaks;
}

PolarPose PolarSearch::refined(const cv::Mat& grey, int level, const PolarPose& coarse) const {
  constexpr int kReach = 2;  // [px] and columns around the result of the coarser level
  const PolarTemplate& object = templates_[level];
  const cv::Point2d middle = imaging::from_level(coarse.pose.position(), 1);
  const int shift = cvRound(coarse.pose.theta * object.grid().angles / (2 * kPi));
  PolarPose best{{}, -2};
  for (int dy = -kReach; dy <= kReach; ++dy)
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const cv::Point2d centre(std::round(middle.x) + dx, std::round(middle.y) + dy);
      const PolarPose pose =
          best_rotation(object, grey, centre, shift - kReach - 1, 2 * kReach + 3);
      if (pose.similarity > best.similarity) best = pose;
    }
  return best;
}

PolarPose PolarSearch::interpolated(const cv::Mat& grey, const PolarPose& best) const {
  const PolarTemplate& object = templates_[0];
  const int shift = cvRound(best.pose.theta * object.grid().angles / (2 * kPi));
  const auto at = [&](double dx, double dy) {
    return best_rotation(object, grey, best.pose.position() + cv::Point2d(dx, dy), shift - 1, 3)
        .similarity;
  };
  const auto turned =
      object.similarities(polar_image(grey, best.pose.position(), object.grid()), shift - 1, 3);
  PolarPose result = best;
  result.pose.x += peak_offset(at(-1, 0), best.similarity, at(1, 0));
  result.pose.y += peak_offset(at(0, -1), best.similarity, at(0, 1));
  result.pose.theta = wrap_angle(2 * kPi * (shift + peak_offset(turned[0], turned[1], turned[2])) /
                                 object.grid().angles);
  return result;
}

}  // namespace mbncc
