#include <algorithm>
#include <cmath>

#include "matching/evidence.hpp"
#include "matching/kernels.hpp"

namespace mbncc {
namespace {

constexpr double kNoise = 60;     // [grey^2] keeps plain surfaces from pulling
constexpr double kMaxStep = 1.5;  // [px] of one step, at the rim for a turn

/// Adds the pull of the surface: normal equations of the motion that explains what the picture
/// shows beyond the template, by the template's slopes.
void add_surface_pull(const SurfaceTemplate& surface, const SurfaceSample& sample,
                      double correlation, ContourPull& pull) {
  constexpr int kRows = 4;
  cv::Vec3d right;
  double common = 0;
  for (int c = 0; c < SurfaceTemplate::kChannels; ++c) {
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

cv::Vec3d bounded_step(const ContourPull& pull, double radius) {
  cv::Matx33d hessian = pull.hessian;
  hessian(0, 0) += 1e-4;
  hessian(1, 1) += 1e-4;
  hessian(2, 2) += 1e-4 * radius * radius;
  cv::Vec3d step = hessian.inv() * pull.gradient;
  const double length = std::max(std::hypot(step[0], step[1]), std::abs(step[2]) * radius);
  if (length > kMaxStep) step *= kMaxStep / length;
  return step;
}

}  // namespace

Climbed climb(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
              int iterations, int reach) {
  thread_local SurfaceSample sample;
  Climbed best{start, -2};
  Pose2D pose = start;
  for (int k = 0; k <= iterations; ++k) {
    object.surface.sample(scene, pose, sample);
    if (!sample.suffices()) break;
    const double correlation = object.surface.projected_correlation(sample, kNoise);
    const double value = contour_agreement(object.contour, scene.edges, pose) + correlation;
    if (value > best.value) best = {pose, value};
    if (k == iterations) break;
    ContourPull pull = contour_pull(object.contour, scene.edges, pose, reach);
    add_surface_pull(object.surface, sample, correlation, pull);
    const cv::Vec3d step = bounded_step(pull, object.surface.radius());
    if (std::hypot(step[0], step[1], step[2] * object.surface.radius()) < 0.01) break;
    pose = compose(pose, inverse(Pose2D{step[0], step[1], step[2]}));
  }
  return best;
}

}  // namespace mbncc
