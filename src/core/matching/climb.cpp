#include <algorithm>
#include <cmath>

#include "matching/evidence.hpp"
#include "polar/kernels.hpp"

namespace mbncc {
namespace {

constexpr double kNoise = 60;        // [grey^2] keeps plain surfaces from pulling
constexpr double kMaxStep = 1.5;     // [px] of one step, at the rim for a turn
constexpr double kSmallStep = 0.01;  // [px] ends the climb
constexpr int kReach = 2;            // [px] along the normals in which edges are looked for

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

/// What is read at a pose; kept from climb to climb, since it takes memory.
struct Samples {
  SurfaceSample surface;
  ContourSample contour;
};

/// The climb of one template in one picture.
class Climber {
 public:
  Climber(const PoseTemplate& object, const SceneLevel& scene, double contour_weight)
      : object_(object), scene_(scene), contour_weight_(contour_weight), samples_(samples()) {}

  Climbed run(const Pose2D& start, int iterations) {
    Climbed best{start, -2, {}};
    Pose2D pose = start;
    for (int k = 0; look_at(pose); ++k) {
      if (value_ > best.value) best = {pose, value_, {}};
      if (k == iterations) break;
      const cv::Vec3d step = next_step();
      if (length_of(step, radius()) < kSmallStep) break;
      pose = compose(pose, inverse(Pose2D{step[0], step[1], step[2]}));
    }
    return best;
  }

  cv::Matx33d covariance(const Pose2D& pose);

 private:
  static Samples& samples() {
    thread_local Samples samples;
    return samples;
  }

  double radius() const { return object_.surface.radius(); }

  /// Samples at `pose`; false when too little is visible.
  bool look_at(const Pose2D& pose) {
    scene_.prepare_around(pose, object_.reach());
    object_.surface.sample(scene_, pose, samples_.surface);
    if (!samples_.surface.suffices()) return false;
    read_contour(object_.contour, scene_.edges, pose, kReach, samples_.contour);
    correlation_ = object_.surface.correlation(object_.surface.remainder(samples_.surface), kNoise);
    value_ = contour_weight_ * contour_agreement(object_.contour, samples_.contour) + correlation_;
    return true;
  }

  cv::Vec3d next_step() {
    ContourPull pull = contour_pull(object_.contour, samples_.contour);
    pull.hessian *= contour_weight_;
    pull.gradient *= contour_weight_;
    add_surface_pull(object_.surface, samples_.surface, correlation_, pull);
    const cv::Vec3d step = damped(pull.hessian, radius()).inv() * pull.gradient;
    return step * std::min(1.0, kMaxStep / (length_of(step, radius()) + 1e-9));
  }

  SurfaceDifference difference() const;
  cv::Matx33d information(const SurfaceDifference& seen) const;
  cv::Matx33d displacement(const SurfaceDifference& seen) const;

  const PoseTemplate& object_;
  const SceneLevel& scene_;
  double contour_weight_;
  Samples& samples_;
  double correlation_ = 0, value_ = -2;  // at the pose looked at last
};

/// What is seen at the pose looked at last beside the template, in the template's contrast.
SurfaceDifference Climber::difference() const {
  constexpr double kLeastContrast = 0.1;
  const double contrast = std::max(kLeastContrast, object_.surface.contrast(samples_.surface));
  SurfaceDifference seen = object_.surface.difference(samples_.surface, contrast);
  seen.rest /= contrast * contrast;
  seen.shading /= contrast * contrast;
  return seen;
}

/// Least squares says the variance of what the template leaves unexplained times the inverse of the
/// slopes' products, for independent values. Smoothing and shading make neighbours alike: fewer
/// independent ones. The contour says as much as its points scatter.
cv::Matx33d Climber::information(const SurfaceDifference& seen) const {
  constexpr double kCorrelatedValues = 45;
  constexpr double kQuantised = 0.3;       // [grey^2] of the least noise
  constexpr double kScatter = 0.8;         // [px] of one contour point
  constexpr double kCorrelatedPoints = 6;  // neighbours on the contour that scatter alike
  return object_.surface.slope_product * (1 / (kCorrelatedValues * (seen.rest + kQuantised))) +
         contour_products(object_.contour, samples_.contour) *
             (1 / (kScatter * kScatter * kCorrelatedPoints));
}

/// Light that does not turn with the object displaces surface and contour by a part of what it is
/// seen to change, and that error does not average out. Fitted to drawn scenes under a lamp, in
/// diffuse light and in even light.
cv::Matx33d Climber::displacement(const SurfaceDifference& seen) const {
  constexpr double kPlace = 0.018, kRim = 0.028;            // [px] in even light
  constexpr double kPlaceShare = 0.125, kRimShare = 0.064;  // of the displacement by shading
  constexpr double kPlain = 1;  // [grey^2 / px^2] bounds that of plain surfaces
  const SurfaceTemplate& surface = object_.surface;
  const double slope = (surface.slope_product(0, 0) + surface.slope_product(1, 1)) /
                       (2 * SurfaceTemplate::kChannels * static_cast<double>(surface.size()));
  const double shading = seen.shading / (slope + kPlain);  // [px^2]
  const double place = kPlace * kPlace + kPlaceShare * kPlaceShare * shading;
  const double rim = kRim * kRim + kRimShare * kRimShare * shading;
  return cv::Matx33d::diag({place, place, rim / (radius() * radius())});
}

/// Where too little is visible nothing is known.
cv::Matx33d Climber::covariance(const Pose2D& pose) {
  cv::Matx33d in_template = damped(cv::Matx33d::zeros(), radius()).inv();
  if (look_at(pose)) {
    const SurfaceDifference seen = difference();
    in_template = damped(information(seen), radius()).inv() + displacement(seen);
  }
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  const cv::Matx33d turn(c, -s, 0, s, c, 0, 0, 0, 1);
  return turn * in_template * turn.t();
}

}  // namespace

Climbed climb(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
              int iterations) {
  return Climber(object, scene, 1).run(start, iterations);
}

Climbed settle(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& start,
               int iterations) {
  constexpr double kContourWeight = 0.1;
  Climber climber(object, scene, kContourWeight);
  Climbed settled = climber.run(start, iterations);
  settled.covariance = climber.covariance(settled.pose);
  return settled;
}

}  // namespace mbncc
