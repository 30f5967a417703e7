#include "matching/refine.hpp"

#include <algorithm>
#include <cmath>

#include "matching/map_level.hpp"
#include "matching/sampling.hpp"
#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

constexpr float kInside = 0.5f;      // [0..1] coverage of a template pixel
constexpr double kMaxShift = 1.5;    // [px] of one step
constexpr double kMaxTurn = 0.3;     // [rad] of one step
constexpr double kDamping = 1.0005;  // keeps flat directions from running away

/// Slope along one axis from neighbours inside the map only.
float slope(const MapLevel& level, cv::Point at, cv::Point step) {
  const cv::Rect all({0, 0}, level.values.size());
  const auto inside = [&](cv::Point p) {
    return all.contains(p) && level.coverage.at<float>(p) >= kInside;
  };
  const bool before = inside(at - step), after = inside(at + step);
  if (!before && !after) return 0;
  const float low = level.values.at<float>(before ? at - step : at);
  const float high = level.values.at<float>(after ? at + step : at);
  return (high - low) / (before && after ? 2.f : 1.f);
}

std::vector<cv::Point> inside_pixels(const MapLevel& level, std::size_t most) {
  std::vector<cv::Point> pixels;
  cv::findNonZero(level.coverage >= kInside, pixels);
  if (pixels.size() <= most) return pixels;
  std::vector<cv::Point> thinned;
  for (std::size_t i = 0; i < most; ++i) thinned.push_back(pixels[i * pixels.size() / most]);
  return thinned;
}

/// pose composed with the inverse of the template's step.
Pose2D moved_back(const Pose2D& pose, const cv::Vec3d& step) {
  return compose(pose, inverse(Pose2D{step[0], step[1], step[2]}));
}

}  // namespace

/// Picture values at the template's points.
struct Refiner::Sample {
  std::vector<float> values;
  double similarity = 0;
  double gain = 0, offset = 0;  // picture = gain * (template - mean) + offset
  double residual = 0;          // [grey^2] mean square of what that leaves
};

Refiner::Refiner(const cv::Mat& grey, const cv::Mat& map, cv::Point2d anchor, int level,
                 std::size_t most_points) {
  const MapLevel at_level = map_level(grey, map, level);
  const cv::Point2d origin = to_level(anchor, level);
  for (const auto& pixel : inside_pixels(at_level, most_points)) {
    const auto x = static_cast<float>(pixel.x - origin.x);
    const auto y = static_cast<float>(pixel.y - origin.y);
    points_.x.push_back(x);
    points_.y.push_back(y);
    points_.values.push_back(at_level.values.at<float>(pixel));
    slope_x_.push_back(slope(at_level, pixel, {1, 0}));
    slope_y_.push_back(slope(at_level, pixel, {0, 1}));
    slope_turn_.push_back(slope_y_.back() * x - slope_x_.back() * y);
  }
  const auto count = static_cast<double>(points_.size());
  for (float value : points_.values) mean_ += value / count;
  cv::Matx<double, 5, 5> normal = cv::Matx<double, 5, 5>::zeros();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const cv::Vec<double, 5> row(slope_x_[i], slope_y_[i], slope_turn_[i],
                                 points_.values[i] - mean_, 1);
    normal += row * row.t();
    energy_ += row[3] * row[3];
  }
  for (int k = 0; k < 3; ++k) normal(k, k) *= kDamping;
  if (points_.size() > 5) inverse_ = normal.inv(cv::DECOMP_CHOLESKY, &solvable_);
}

Refiner::Sample Refiner::sample(const cv::Mat& grey, const Pose2D& pose) const {
  const GreySampler picture(grey);
  const auto c = static_cast<float>(std::cos(pose.theta)),
             s = static_cast<float>(std::sin(pose.theta));
  const auto x0 = static_cast<float>(pose.x), y0 = static_cast<float>(pose.y);
  constexpr float kInvisible = -1;
  Sample result;
  result.values.resize(points_.size());
  double count = 0, sum = 0, square = 0, t_sum = 0, t_square = 0, product = 0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const float x = c * points_.x[i] - s * points_.y[i] + x0;
    const float y = s * points_.x[i] + c * points_.y[i] + y0;
    result.values[i] = kInvisible;
    if (!picture.contains(x, y)) continue;
    const double value = result.values[i] = picture(x, y);
    const double t = points_.values[i] - mean_;
    count += 1;
    sum += value;
    square += value * value;
    t_sum += t;
    t_square += t * t;
    product += t * value;
  }
  if (count * 4 < static_cast<double>(points_.size()) || count < 1) return result;
  const double variance_t = t_square / count - t_sum / count * (t_sum / count);
  const double variance_s = std::max(0.0, square / count - sum / count * (sum / count));
  const double covariance = product / count - t_sum / count * (sum / count);
  result.similarity =
      covariance / std::sqrt((variance_t + kNoiseVariance) * (variance_s + kNoiseVariance));
  result.gain = covariance / (variance_t + 1e-9);
  result.offset = sum / count - result.gain * t_sum / count;
  result.residual = std::max(0.0, variance_s - result.gain * covariance);
  // Points beyond the border must not pull: they take the value that the fit predicts.
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (result.values[i] == kInvisible)
      result.values[i] =
          static_cast<float>(result.gain * (points_.values[i] - mean_) + result.offset);
  return result;
}

cv::Vec<double, 5> Refiner::fit(const Sample& sample) const {
  cv::Vec<double, 5> right;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double value = sample.values[i] - sample.offset;
    right += value * cv::Vec<double, 5>(slope_x_[i], slope_y_[i], slope_turn_[i],
                                        points_.values[i] - mean_, 1);
  }
  return inverse_ * right;
}

RefinedPose Refiner::refine(const cv::Mat& grey, const Pose2D& start, int iterations) const {
  Pose2D pose = start;
  Sample current = sample(grey, pose);
  RefinedPose best{start, current.similarity, {}};
  double residual = current.residual, gain = current.gain;
  for (int k = 0; k < iterations && solvable_; ++k) {
    const auto solution = fit(current);
    if (solution[3] < 1e-3) break;
    cv::Vec3d step(solution[0] / solution[3], solution[1] / solution[3], solution[2] / solution[3]);
    const double shift = std::hypot(step[0], step[1]);
    if (shift > kMaxShift) step *= kMaxShift / shift;
    step[2] = std::clamp(step[2], -kMaxTurn, kMaxTurn);
    pose = moved_back(pose, step);
    current = sample(grey, pose);
    if (current.similarity <= best.similarity) break;
    best.pose = pose;
    best.similarity = current.similarity;
    residual = current.residual;
    gain = current.gain;
  }
  if (solvable_ && gain > 0)
    best.covariance = inverse_.get_minor<3, 3>(0, 0) * ((residual + 1) / (gain * gain));
  return best;
}

}  // namespace mbncc
