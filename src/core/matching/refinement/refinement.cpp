// SPDX-License-Identifier: BSD-3-Clause
#include "matching/refinement/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "matching/refinement/illumination_bias.hpp"
#include "matching/refinement/surface_residuals.hpp"
#include "numeric/random_effects.hpp"

namespace mbncc::refinement {
namespace {

constexpr int kReach = 2;               // [px] search range for edges along the normals, ...
constexpr int kFarReach = 5;            // ... and when halves of the object are compared
constexpr double kSmallStep = 0.01;     // [px] a smaller step ends the refinement
constexpr double kFarthest = 1.5;       // [px] farthest from the start; of a rotation, at the rim
constexpr double kScalePrior = 0.02;    // standard deviation caused by heights and tilts
constexpr double kLeastScale = 0.006;   // least deviation from 1 that is reported, ...
constexpr double kScaleDeviations = 5;  // ... and in standard deviations
constexpr double kMostScale = 0.08;     // a larger deviation means another object
constexpr double kFixedScale = 1e-6;    // standard deviation that fixes the scale

class Refiner {
 public:
  Refiner(const RefinementTemplate& object, const scene::SceneLevel& scene, const Pose2D& start,
          double scale)
      : object_(object),
        scene_(scene),
        start_(start),
        pose_(start),
        first_scale_(scale),
        scale_(scale) {}

  Refined run(int iterations) {
    bool seen = approach(iterations, kFixedScale);
    if (seen && iterations > 0 && scale_differs()) {
      seen = approach(iterations, kScalePrior);
    } else if (scale_ != 1) {
      scale_ = 1;
      seen = approach(iterations, kFixedScale);
    }
    if (left_search_range()) {
      pose_ = start_;
      scale_ = first_scale_;
      seen = linearise();
    }
    if (!seen) return unknown_accuracy(pose_);
    const double apart = std::max(between_cue_variance_, variance_between_halves());
    return {pose_, scale_, covariance(between_cue_variance_), covariance(apart), scale_variance()};
  }

 private:
  struct Samples {
    templates::SurfaceSample surface;
    templates::ContourSample contour;
    SurfaceResiduals remainders;
  };

  double radius() const { return object_.object.surface.radius(); }

  /// Iterates until the steps are small. False if too little is visible.
  bool approach(int iterations, double scale_deviation) {
    scale_deviation_ = scale_deviation;
    for (int k = 0; linearise(); ++k) {
      if (k == iterations) return true;
      numeric::Motion step = solution(scale_deviation_);
      if (scale_deviation_ == kFixedScale) step[3] = 0;
      move(step);
      if (length_of(step) < kSmallStep) return true;  // the reading would not change
    }
    return false;
  }

  bool linearise();
  double variance_between_halves();
  numeric::NormalEquations half_pull(double x, double y);
  double gain() const;
  numeric::NormalEquations edges_pull(const templates::ContourSample& sample) const;
  scene::PreparedPixels pixels() const {
    return scene_.around(pose_, object_.object.reach() * scale_);
  }
  void read_edges(int reach) {
    templates::read_contour(object_.object.contour, pixels().edges, pose_, reach, samples_.contour,
                            scale_);
  }
  std::array<numeric::NormalEquations, ColourAxes::kAxes> axis_pulls(
      const std::vector<float>& weights);
  numeric::NormalEquations sum_of(
      numeric::NormalEquations contour,
      const std::array<numeric::NormalEquations, ColourAxes::kAxes>& axes) const;

  cv::Matx44d information(double scale_deviation) const {
    cv::Matx44d prior = cv::Matx44d::diag({kLeast, kLeast, kLeast * radius() * radius(), 0});
    prior(3, 3) = 1 / (scale_deviation * scale_deviation);
    return pull_.information + prior;
  }

  numeric::Motion solution(double scale_deviation) const {
    numeric::Motion towards = pull_.vector;
    if (scale_deviation != kFixedScale)
      towards[3] += (scale_ - 1) / (scale_deviation * scale_deviation);
    return information(scale_deviation).inv() * towards;
  }

  double estimated_scale() const { return scale_ / (1 + solution(kScalePrior)[3]); }

  double scale_variance() const {
    const double off = estimated_scale() - scale_;
    return off * off + information(kScalePrior).inv()(3, 3);
  }

  /// Whether the scale of the current solution differs significantly from 1.
  bool scale_differs() const {
    const double off = std::abs(estimated_scale() - 1);
    const double deviation = std::sqrt(information(kScalePrior).inv()(3, 3));
    return off > std::max(kLeastScale, kScaleDeviations * deviation);
  }

  void move(const numeric::Motion& step) {
    const double bound = std::min(1.0, kFarthest / (length_of(step) + 1e-9));
    const numeric::Motion bounded = step * bound;
    scale_ /= 1 + bounded[3];
    pose_.theta -= bounded[2];
    pose_ = compose(pose_, {-scale_ * bounded[0], -scale_ * bounded[1], 0});
  }

  double length_of(const numeric::Motion& step) const {
    return std::max(std::hypot(step[0], step[1]), std::hypot(step[2], step[3]) * radius());
  }

  bool left_search_range() const {
    return std::hypot(pose_.x - start_.x, pose_.y - start_.y) > kFarthest ||
           angle_distance(pose_.theta, start_.theta) * radius() > kFarthest ||
           std::abs(scale_ - 1) > kMostScale;
  }

  cv::Matx33d covariance(double between_cue_variance) const;
  static constexpr double kLeast = 1e-4;  // [1/px^2] prior information

  const RefinementTemplate& object_;
  const scene::SceneLevel& scene_;
  Pose2D start_, pose_;
  double first_scale_, scale_, scale_deviation_ = kFixedScale;
  Samples samples_;
  numeric::NormalEquations pull_, edges_;  // at the last linearisation
  double contrast_ = 1;                    // of the image relative to the template
  double between_cue_variance_ = 0;        // [px^2] random-effects variance of the cues
  IlluminationBias illumination_bias_;     // at the last linearisation
};

/// Builds the normal equations of surface and contour at the pose. False if too little is visible.
bool Refiner::linearise() {
  const templates::PoseTemplate& object = object_.object;
  object.surface.sample(pixels(), pose_, samples_.surface, scale_);
  if (!samples_.surface.suffices()) return false;
  contrast_ = gain();
  illumination_bias_ = IlluminationBias(object.surface, samples_.surface, contrast_);
  read_edges(kReach);
  edges_ = edges_pull(samples_.contour);
  samples_.remainders.read(object_.axes, object.surface, samples_.surface);
  const auto axes = axis_pulls(samples_.remainders.weights);
  between_cue_variance_ =
      numeric::random_effects_variance({edges_, axes[0], axes[1], axes[2]}, radius());
  pull_ = sum_of(edges_, axes);
  return true;
}

/// Normal equations of one half of the object, on one side of a direction in the template's frame.
numeric::NormalEquations Refiner::half_pull(double x, double y) {
  const auto on_side = [&](double px, double py) { return px * x + py * y > 0; };
  const templates::PoseTemplate& object = object_.object;
  templates::ContourSample contour = samples_.contour;
  for (std::size_t i = 0; i < object.contour.size(); ++i)
    if (!on_side(object.contour.x[i], object.contour.y[i])) contour.pull[i] = contour.moment[i] = 0;
  const numeric::NormalEquations pull = edges_pull(contour);
  std::vector<float> weights = samples_.remainders.weights;
  for (std::size_t i = 0; i < object.surface.size(); ++i)
    if (!on_side(object.surface.x[i], object.surface.y[i])) weights[i] = 0;
  return sum_of(pull, axis_pulls(weights));
}

/// [px^2] Variance between halves of the object, split along the image's rows and columns, beyond
/// their covariances: in an image that is torn by motion, one half is displaced.
double Refiner::variance_between_halves() {
  read_edges(kFarReach);
  const double c = std::cos(pose_.theta), s = std::sin(pose_.theta);
  double most = 0;
  for (const auto& [x, y] : {std::make_pair(c, -s), std::make_pair(s, c)}) {
    const double apart =
        numeric::random_effects_variance({half_pull(x, y), half_pull(-x, -y)}, radius());
    most = std::max(most, apart);
  }
  return most;
}

numeric::NormalEquations Refiner::edges_pull(const templates::ContourSample& sample) const {
  constexpr double kScatter = 0.8;         // [px] standard deviation of one contour point
  constexpr double kCorrelatedPoints = 2;  // neighbours on the contour with equal errors
  const double scatter = kScatter * kScatter * kCorrelatedPoints;
  numeric::NormalEquations edges = object_.contour_motion.pull(sample);
  edges.information *= 1 / scatter;
  edges.vector *= 1 / scatter;
  return numeric::marginalised_over_shift(edges, illumination_bias_.of_contour());
}

std::array<numeric::NormalEquations, ColourAxes::kAxes> Refiner::axis_pulls(
    const std::vector<float>& weights) {
  constexpr double kCorrelatedValues = 4;  // neighbours with equal noise, by smoothing
  const SurfaceResiduals& remainders = samples_.remainders;
  const auto variances = remainders.variances();
  const double lesson_noise = object_.axes.noise(remainders.values, remainders.weights, contrast_);
  std::array<numeric::NormalEquations, ColourAxes::kAxes> pulls;
  for (int axis = 0; axis < ColourAxes::kAxes; ++axis) {
    pulls[axis] = object_.axes.pull(axis, remainders.values[axis], weights);
    const double noise = kCorrelatedValues * variances[axis];
    const double share = contrast_ * object_.axes.reliability(axis, lesson_noise);
    pulls[axis].information *= share * share / noise;
    pulls[axis].vector *= share / noise;
  }
  numeric::NormalEquations& brightness = pulls[ColourAxes::kBrightness];
  brightness = numeric::marginalised_over_shift(brightness, illumination_bias_.of_brightness());
  return pulls;
}

/// Normal equations of contour and surface. Those of colour are marginalised over a displacement if
/// they disagree with the whole contour: cameras blur and displace colour, some by pixels.
numeric::NormalEquations Refiner::sum_of(
    numeric::NormalEquations contour,
    const std::array<numeric::NormalEquations, ColourAxes::kAxes>& axes) const {
  constexpr double kUsual = 0.3;  // [px] distance between colour and contour
  numeric::NormalEquations colour = axes[1];
  colour += axes[2];
  const double apart = std::sqrt(2 * numeric::random_effects_variance({colour, edges_}, radius()));
  contour += axes[ColourAxes::kBrightness];
  contour +=
      apart > kUsual ? numeric::marginalised_over_shift_and_turn(colour, apart, radius()) : colour;
  return contour;
}

/// Contrast of the image relative to the template.
double Refiner::gain() const {
  constexpr double kPrior = 20;  // [grey^2] pulls the gain of plain surfaces to 1
  const templates::SurfaceTemplate& surface = object_.object.surface;
  const double energy = surface.mean_projected_energy();
  const double common = surface.contrast(samples_.surface) * energy;
  return std::clamp((common + kPrior) / (energy + kPrior), 0.3, 2.0);
}

/// Covariance of x, y, theta. `between_cue_variance` [px^2]: random-effects variance of cues or
/// halves.
cv::Matx33d Refiner::covariance(double between_cue_variance) const {
  constexpr double kAlike = 3;  // factor, because the cause also displaces all cues together
  const double rim = radius() * radius();
  const cv::Matx33d in_template =
      information(scale_deviation_).inv().get_minor<3, 3>(0, 0) +
      illumination_bias_.of_pose(radius()) +
      kAlike * between_cue_variance * cv::Matx33d::diag({1, 1, 1 / rim});
  const double c = std::cos(pose_.theta), s = std::sin(pose_.theta);
  const cv::Matx33d turn(c, -s, 0, s, c, 0, 0, 0, 1);
  return turn * in_template * turn.t();
}

}  // namespace

RefinementTemplate::RefinementTemplate(templates::PoseTemplate made,
                                       const scene::PreparedPixels& image)
    : object(std::move(made)), axes(object.surface, image), contour_motion(object.contour) {}

Refined unknown_accuracy(const Pose2D& pose) {
  constexpr double kPlace = 100;  // [px]
  const auto unknown = cv::Matx33d::diag({kPlace * kPlace, kPlace * kPlace, 4 * kPi * kPi});
  return {pose, 1, unknown, unknown};
}

Refined refine(const RefinementTemplate& object, const scene::SceneLevel& scene,
               const Pose2D& start, int iterations, double scale) {
  return Refiner(object, scene, start, scale).run(iterations);
}

}  // namespace mbncc::refinement
