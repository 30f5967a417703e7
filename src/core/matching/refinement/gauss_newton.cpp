// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "matching/refinement/gauss_newton.hpp"
#include "simd/kernels.hpp"

namespace mbncc::refinement {
namespace {

constexpr double kNoise = 60;        // [grey^2] regularises plain surfaces
constexpr double kMaxStep = 1.5;     // [px] largest step; of a rotation, at the rim
constexpr double kSmallStep = 0.01;  // [px] a smaller step ends the alignment
constexpr int kReach = 2;            // [px] search range for edges along the normals

/// Adds the normal equations of the surface: the motion that explains the residual by the
/// template's slopes.
void add_surface_pull(const templates::SurfaceTemplate& surface,
                      const templates::SurfaceSample& sample, double correlation,
                      templates::ContourPull& pull) {
  constexpr int kRows = 4;
  cv::Vec3d right;
  double common = 0;
  for (int c = 0; c < templates::SurfaceTemplate::kChannels; ++c) {
    float products[kRows];
    kernels::dots(surface.slopes[c].data(), surface.padded(), kRows, sample.planes[c].data(),
                  static_cast<int>(surface.padded()), products);
    right += cv::Vec3d(products[0], products[1], products[2]);
    common += products[3];
  }
  if (correlation < 0.05 || common <= 0) return;
  pull.hessian += surface.slope_product * (correlation / surface.projected_energy);
  pull.gradient += right * (correlation / common);
}

cv::Matx33d damped(cv::Matx33d hessian, double radius) {
  constexpr double kDamping = 1e-4;
  hessian(0, 0) += kDamping;
  hessian(1, 1) += kDamping;
  hessian(2, 2) += kDamping * radius * radius;
  return hessian;
}

double length_of(const cv::Vec3d& step, double radius) {
  return std::max(std::hypot(step[0], step[1]), std::abs(step[2]) * radius);
}

cv::Vec3d bounded(const cv::Vec3d& step, double radius) {
  return step * std::min(1.0, kMaxStep / (length_of(step, radius) + 1e-9));
}

/// The alignment of one template in one image.
class Aligner {
 public:
  Aligner(const templates::PoseTemplate& object, const scene::SceneLevel& scene)
      : object_(object), scene_(scene), sample_(shared_sample()) {}

  AlignedPose run(const Pose2D& start, int iterations) {
    AlignedPose best{start, -2};
    Pose2D pose = start;
    // Only the value is needed at the last pose. It does not depend on distant edges.
    for (int k = 0; linearise(pose, k == iterations ? 0 : kReach); ++k) {
      at_best_ = value_ > best.value;
      if (at_best_) best = {pose, value_};
      if (k == iterations) break;
      const cv::Vec3d step = next_step();
      if (length_of(step, radius()) < kSmallStep) break;
      pose = compose(pose, inverse(Pose2D{step[0], step[1], step[2]}));
    }
    return best;
  }

  ScoredPose run_to_evidence(const Pose2D& start, int iterations) {
    const Pose2D best = run(start, iterations).pose;
    if (!at_best_) sample_.read(object_, scene_, best, 0);
    return {best, evidence::gather_evidence(object_, scene_, best, sample_)};
  }

 private:
  /// Reused by the next alignment, to avoid allocations.
  static templates::PoseSample& shared_sample() {
    thread_local templates::PoseSample sample;
    return sample;
  }

  double radius() const { return object_.surface.radius(); }

  /// Reads the image at `pose`; false if too little is visible.
  bool linearise(const Pose2D& pose, int reach) {
    at_best_ = false;
    sample_.read(object_, scene_, pose, reach);
    if (!sample_.surface.suffices()) return false;
    correlation_ = object_.surface.correlation(sample_.residual, kNoise);
    value_ = templates::contour_agreement(object_.contour, sample_.contour) + correlation_;
    return true;
  }

  cv::Vec3d next_step() {
    templates::ContourPull pull = templates::contour_pull(object_.contour, sample_.contour);
    add_surface_pull(object_.surface, sample_.surface, correlation_, pull);
    return bounded(damped(pull.hessian, radius()).inv() * pull.gradient, radius());
  }

  const templates::PoseTemplate& object_;
  const scene::SceneLevel& scene_;
  templates::PoseSample& sample_;        // at the last linearisation
  double correlation_ = 0, value_ = -2;  // at the last linearisation
  bool at_best_ = false;                 // `sample_` was read at the best pose
};

}  // namespace

AlignedPose align(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                  const Pose2D& start, int iterations) {
  return Aligner(object, scene).run(start, iterations);
}

ScoredPose align_and_score(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                           const Pose2D& start, int iterations) {
  return Aligner(object, scene).run_to_evidence(start, iterations);
}

}  // namespace mbncc::refinement
