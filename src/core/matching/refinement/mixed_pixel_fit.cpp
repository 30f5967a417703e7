// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "matching/refinement/mixed_pixel_equations.hpp"
#include "matching/refinement/mixed_pixel_model.hpp"
#include "matching/refinement/mixed_pixel_sample.hpp"
#include "simd/lanes.hpp"

namespace mbncc::refinement {
namespace {

constexpr int kAxes = MixedPixelEquations::kAxes, kMotion = MixedPixelEquations::kMotion;

/// Gauss-Newton in light and motion together; outliers have less weight, and so do values along an
/// axis of colour with many outliers.
class MixedPixelFitter {
 public:
  MixedPixelFitter(const MixedPixelModel& object, const scene::SceneLevel& scene)
      : object_(object), scene_(scene), equations_(object) {}

  MixedPixelFit run(const Pose2D& start) {
    scene_.prepare_around(start, object_.reach + kFar);
    return described(finalised(start));
  }

 private:
  static constexpr double kFar = 4;  // [px] from the start

  Pose2D finalised(const Pose2D& start) {
    constexpr int kIterations = 8;
    Pose2D pose = start, best = start;
    double least = 0;
    for (int k = 0; k <= kIterations && linearise(pose); ++k) {
      const double cost = k == 0 ? first_cost() : weigh();
      if (k == 0 || cost < least) {
        least = cost;
        best = pose;
      }
      const cv::Vec3d step = next_step(pose);
      pose = {pose.x + step[0], pose.y + step[1], pose.theta + step[2] / object_.radius};
      if (cv::norm(step) < 0.02 || cv::norm(pose.position() - start.position()) > kFar) break;
    }
    return best;
  }

  /// Observation at a pose.
  MixedPixelFit described(const Pose2D& pose) {
    constexpr int kSettling = 2;  // alternations of weights and light
    MixedPixelFit rendered{pose};
    if (!linearise(pose)) return rendered;
    auto& weights = equations_.weights();
    std::fill(weights.begin(), weights.end(), 1.f);
    first_cost();
    for (int k = 0; k < kSettling; ++k) weigh();
    rendered.misfit = misfit();
    rendered.brightness = brightness();
    return rendered;
  }

  double misfit() const;
  double brightness() const;

  /// False when too little is visible.
  bool linearise(const Pose2D& pose) {
    read_rendering(object_, scene_, pose, seen_);
    equations_.read(seen_);
    seen_points_ = kernels::product(seen_.inside, seen_.inside.data());
    return 2 * seen_points_ >= object_.size;
  }

  /// Slopes change little within this; computing them takes six readings.
  bool is_near(const Pose2D& pose, const Pose2D& other) const {
    constexpr double kNear = 0.1;  // [px]
    return cv::norm(pose.position() - other.position()) < kNear &&
           angle_distance(pose.theta, other.theta) * object_.radius < kNear;
  }

  void numeric_jacobian(const Pose2D& pose);
  double first_cost();
  double weigh();

  /// Residual after the best light.
  void update_residual() { equations_.subtract(equations_.light(), residual_); }

  cv::Vec3d next_step(const Pose2D& pose) {
    constexpr double kMost = 1;  // [px]
    if (!slopes_at_ || !is_near(pose, *slopes_at_)) numeric_jacobian(pose);
    const cv::Vec3d step = equations_.motion();
    return step * std::min(1.0, kMost / (cv::norm(step) + 1e-9));
  }

  const MixedPixelModel& object_;
  const scene::SceneLevel& scene_;
  MixedPixelEquations equations_;
  MixedPixelSample seen_;
  std::optional<Pose2D> slopes_at_;
  double seen_points_ = 0;
  std::vector<float> residual_;        // per axis and point
  std::array<float, kAxes> scales_{};  // [grey levels] scale of outliers, per axis
};

/// Central differences along x, y and the rim.
void MixedPixelFitter::numeric_jacobian(const Pose2D& pose) {
  constexpr double kStep = 0.5;  // [px]
  thread_local MixedPixelSample low, high;
  for (int k = 0; k < kMotion; ++k) {
    Pose2D before = pose, after = pose;
    double* const moved[] = {&before.x, &before.y, &before.theta, &after.x, &after.y, &after.theta};
    const double step = k == 2 ? kStep / object_.radius : kStep;
    *moved[k] -= step;
    *moved[kMotion + k] += step;
    read_rendering(object_, scene_, before, low);
    read_rendering(object_, scene_, after, high);
    equations_.set_slope(k, low, high);
  }
  slopes_at_ = pose;
}

/// The scales of outliers are those of the residuals at the start.
double MixedPixelFitter::first_cost() {
  constexpr std::array<float, kAxes> kQuantised{6, 4, 4};  // noise explains
  update_residual();
  const std::size_t padded = object_.padded();
  thread_local std::vector<float> sizes;
  for (std::size_t axis = 0; axis < scales_.size(); ++axis) {
    sizes.clear();
    for (std::size_t i = 0; i < padded; ++i)
      if (seen_.inside[i] > 0) sizes.push_back(std::abs(residual_[axis * padded + i]));
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    scales_[axis] = std::max(kQuantised[axis], 2 * *middle);
  }
  return weigh();
}

/// Weights the values by their residuals in the best light. Returns their mean saturated misfit.
double MixedPixelFitter::weigh() {
  update_residual();
  thread_local std::vector<float> saturated;
  saturated.resize(object_.padded());
  double misfit = 0;
  for (int axis = 0; axis < kAxes; ++axis) {
    const float square_scale = scales_[axis] * scales_[axis], share = scales_[0] / scales_[axis];
    const float* const residual = &residual_[axis * object_.padded()];
    float* const weights = &equations_.weights()[axis * object_.padded()];
    for (std::size_t i = 0; i < object_.padded(); ++i) {
      const float square = residual[i] * residual[i] / square_scale;
      const float telling = share / (1 + square);
      weights[i] = telling * telling;
      saturated[i] = square / (1 + square);
    }
    misfit += kernels::product(saturated, seen_.inside.data());
  }
  return misfit / (kAxes * seen_points_);
}

/// Of the residuals.
double MixedPixelFitter::misfit() const {
  constexpr float kWorst = 60 * 60;  // [grey^2] of one value
  double sum = 0;
  for (int axis = 0; axis < kAxes; ++axis)
    for (std::size_t i = 0; i < object_.padded(); ++i) {
      const float residual = residual_[axis * object_.padded() + i];
      sum += seen_.inside[i] * std::min(residual * residual, kWorst);
    }
  return std::log(std::sqrt(sum / (kAxes * seen_points_)) + 3);
}

/// Of the explained colours, relative to the taught ones.
double MixedPixelFitter::brightness() const {
  constexpr double kDark = 8;             // [grey levels] added before taking the logarithm
  const auto& taught = object_.light[0];  // its gain comes first
  double explained = 0, learned = 0, size = 0;
  for (std::size_t i = 0; i < object_.padded(); ++i) {
    explained += seen_.inside[i] * (seen_.values[i] - residual_[i]);
    learned += seen_.inside[i] * taught[i];
    size += std::sqrt(3.) * seen_.inside[i] * (1 - object_.background[i]);
  }
  return std::log((std::max(0.0, explained / size) + kDark) /
                  (std::max(0.0, learned / size) + kDark));
}

}  // namespace

MixedPixelFit fit(const MixedPixelModel& object, const scene::SceneLevel& scene,
                  const Pose2D& start) {
  return object.padded() == 0 ? MixedPixelFit{start} : MixedPixelFitter(object, scene).run(start);
}

}  // namespace mbncc::refinement
