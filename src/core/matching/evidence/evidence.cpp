// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "imaging/gradient_orientation.hpp"
#include "imaging/kernel_views.hpp"
#include "matching/evidence/local_cast.hpp"
#include "matching/evidence/trimmed_residual.hpp"
#include "simd/lanes.hpp"

namespace mbncc::evidence {
namespace {

constexpr double kLargeArea = 1800;      // [px] beyond it, size no longer reduces chance matches
constexpr double kTrimmedWeight = 4.28;  // weight of Evidence::trimmed_residual in log_odds()

double log_trimmed(double residual) {
  return std::log(residual + 3);
}

double gradient_agreement(const templates::SurfaceTemplate& surface,
                          const templates::SurfaceSample& sample, const cv::Mat& edges,
                          const Pose2D& pose, double scale) {
  thread_local std::vector<float> agreements;
  agreements.resize(surface.padded());
  kernels::edge_agreements(imaging::view_of(edges),
                           {surface.x.data(), surface.y.data(), static_cast<int>(surface.padded())},
                           surface.gradient_x.data(), surface.gradient_y.data(),
                           imaging::placement_of(pose, scale), agreements.data());
  return kernels::product(agreements, sample.inside.data()) /
         (imaging::kEdgeScale * (surface.gradient_total + static_cast<double>(surface.size())));
}

Evidence contour_evidence(const templates::PoseTemplate& object,
                          const templates::PoseSample& sample) {
  Evidence evidence;
  evidence.contour_score = templates::contour_agreement(object.contour, sample.contour);
  evidence.contour_coverage = templates::contour_found(object.contour, sample.contour);
  evidence.texture = object.surface.texture();
  evidence.compared = static_cast<double>(sample.surface.visible) /
                      static_cast<double>(std::max<std::size_t>(1, object.surface.size()));
  return evidence;
}

/// Input of the evidence at a pose.
struct Reading {
  const templates::PoseTemplate& object;
  const scene::SceneLevel& scene;
  const Pose2D& pose;
  double scale;

  const cv::Mat& edges() const { return scene.around(pose, scale * object.reach()).edges; }
};

/// `trimmed`: trimmed_residual() of the sample's blocks.
Evidence evidence_of(const Reading& reading, const templates::PoseSample& sample, double trimmed) {
  constexpr double kNoise = 9;  // [grey^2]
  const templates::SurfaceTemplate& surface = reading.object.surface;
  const templates::SurfaceSample& seen = sample.surface;
  Evidence evidence = contour_evidence(reading.object, sample);
  evidence.gradient =
      gradient_agreement(surface, seen, reading.edges(), reading.pose, reading.scale);
  if (trimmed >= 0) evidence.trimmed_residual = log_trimmed(trimmed);
  evidence.histogram =
      imaging::overlap(surface.histogram, imaging::chroma_histogram(seen.planes, seen.inside));
  evidence.shading_free_ncc = surface.correlation(sample.residual, kNoise);
  evidence.log_residual = std::log(std::sqrt(surface.unexplained(sample.residual)) + 2);
  return evidence;
}

Evidence evidence_without(const ColourCast& cast, const Reading& reading,
                          const templates::PoseSample& sample, double trimmed) {
  thread_local templates::PoseSample without_cast;
  without_cast = sample;
  remove_cast(cast, without_cast.surface);
  without_cast.residual = reading.object.surface.residual(without_cast.surface);
  Evidence evidence = evidence_of(reading, without_cast, trimmed);
  evidence.cast = cast.size();
  return evidence;
}

/// Log-odds penalty of a cast: 2 for the additional degrees of freedom, plus that of a normal
/// distribution with a standard deviation of .09.
double cast_penalty(double cast) {
  constexpr double kFreedom = 2, kSteepness = 60;
  return cast > 0 ? kFreedom + kSteepness * cast * cast : 0;
}

}  // namespace

Evidence gather_evidence(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                         const Pose2D& pose, double scale) {
  thread_local templates::PoseSample sample;
  sample.read(object, scene, pose, 0, scale);
  return gather_evidence(object, scene, pose, sample, scale);
}

Evidence gather_evidence(const templates::PoseTemplate& object, const scene::SceneLevel& scene,
                         const Pose2D& pose, const templates::PoseSample& sample, double scale) {
  constexpr double kLeastCast = 0.05;  // ln of the gains; less is noise
  constexpr double kOtherGain = 6;     // log-odds that other features may gain without the cast
  if (!sample.surface.suffices()) return contour_evidence(object, sample);
  const Reading reading{object, scene, pose, scale};
  auto blocks = templates::block_sums(object.surface, sample.surface);
  const double trimmed = trimmed_residual(blocks);
  const ColourCast cast = bounded(local_cast(blocks).value_or(ColourCast{}));
  const Evidence with_cast = evidence_of(reading, sample, trimmed);
  if (cast.size() < kLeastCast) return with_cast;
  remove_cast(cast, blocks);
  const double without = trimmed_residual(blocks);
  const double gained = kTrimmedWeight * (log_trimmed(trimmed) - log_trimmed(without));
  if (gained + kOtherGain < cast_penalty(cast.size())) return with_cast;
  const Evidence without_cast = evidence_without(cast, reading, sample, without);
  return log_odds(without_cast, kLargeArea) > log_odds(with_cast, kLargeArea) ? without_cast
                                                                              : with_cast;
}

double log_odds(const Evidence& evidence, double area) {
  // Fitted by logistic regression to true and false poses in drawn scenes, together with the
  // clutter penalty (clutter_penalty.hpp). For objects hardly larger than their edge, contour
  // coverage has more weight and gradients have less, because gradients inside are those of the
  // background.
  constexpr double kSmallArea = 700;  // [px] below it the weights change
  const double small = std::max(0.0, std::log(kSmallArea / area));
  return 18.9 * evidence.contour_coverage + 17.3 * evidence.gradient -
         kTrimmedWeight * evidence.trimmed_residual + 6.68 * evidence.histogram +
         9.35 * evidence.shading_free_ncc - 8.29 * evidence.texture +
         0.99 * std::log(std::min(area, kLargeArea)) - 16.5 * (1 - evidence.compared) -
         cast_penalty(evidence.cast) - 12.4 +
         small * (1.17 + 12.35 * evidence.contour_coverage - 23.8 * evidence.gradient -
                  4.32 * evidence.trimmed_residual - 4.09 * evidence.histogram +
                  6.23 * evidence.shading_free_ncc);
}

double rotation_odds(const Evidence& evidence) {
  // Fitted by logistic regression to right and wrong rotations at the same place.
  return 39 * evidence.contour_score + 5 * evidence.shading_free_ncc + 7 * evidence.gradient -
         17 * evidence.log_residual;
}

}  // namespace mbncc::evidence
