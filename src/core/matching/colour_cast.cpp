#include "matching/colour_cast.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr double kLikely = 3;          // log-odds of a detection that is asked
constexpr double kAlike = 0.06;        // ln gain between those that agree
constexpr double kNoticeable = 0.055;  // ln gain from which on a picture is balanced

/// ln gains of blue and red against green at a detection's surface, where no channel is dark or
/// clipped.
std::optional<cv::Point2d> gains_at(const Detection& detection, const ScenePicture& scene) {
  constexpr float kDark = 24, kClipped = 250;
  constexpr int kEnough = 20;
  const SurfaceTemplate& surface = detection.view->fine.surface;
  SurfaceSample sample;
  scene.levels[0].prepare_around(detection.pose, detection.view->fine.reach());
  surface.sample(scene.levels[0], detection.pose, sample);
  cv::Point2d sum;
  int count = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (sample.inside[i] == 0) continue;
    const auto ratio = [&](int channel) {
      return sample.planes[channel][i] / surface.planes[channel][i];
    };
    const auto usable = [&](const auto& planes) {
      return std::all_of(planes.begin(), planes.end(), [i](const std::vector<float>& plane) {
        return plane[i] >= kDark && plane[i] <= kClipped;
      });
    };
    if (!usable(sample.planes) || !usable(surface.planes)) continue;
    sum += {std::log(ratio(0) / ratio(1)), std::log(ratio(2) / ratio(1))};
    ++count;
  }
  if (count < kEnough) return std::nullopt;
  return sum / count;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

cv::Point2d median(const std::vector<cv::Point2d>& points) {
  std::vector<double> x, y;
  for (const auto& point : points) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  return {median(x), median(y)};
}

}  // namespace

std::optional<ColourCast> colour_cast(const std::vector<std::vector<Detection>>& found,
                                      const ScenePicture& scene) {
  std::vector<cv::Point2d> gains;
  for (const auto& own : found)
    if (!own.empty() && own.front().log_odds >= kLikely)
      if (const auto gain = gains_at(own.front(), scene)) gains.push_back(*gain);
  if (gains.size() < 2) return std::nullopt;
  const cv::Point2d middle = median(gains);
  const auto agreeing = std::count_if(gains.begin(), gains.end(), [&](const cv::Point2d& gain) {
    return cv::norm(gain - middle) <= kAlike;
  });
  const bool agreed = agreeing >= 2 && 2 * static_cast<std::size_t>(agreeing) > gains.size();
  if (!agreed || std::max(std::abs(middle.x), std::abs(middle.y)) < kNoticeable)
    return std::nullopt;
  return ColourCast{std::exp(middle.x), std::exp(middle.y)};
}

cv::Mat without_cast(const cv::Mat& picture, const ColourCast& cast) {
  cv::Mat balanced;
  cv::multiply(picture, cv::Scalar(1 / cast.blue, 1, 1 / cast.red), balanced);
  return balanced;
}

}  // namespace mbncc
