#include "matching/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "matching/edge_picture.hpp"
#include "matching/padded_vectors.hpp"
#include "matching/picture_view.hpp"

namespace mbncc {
namespace {

constexpr int kChannels = SurfaceTemplate::kChannels;

/// Gain within bounds and offset that fit the template's colours to the picture's.
kernels::Gain fit_gain(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  constexpr double kPrior = 100;  // [grey^2] pulls the gain of plain surfaces to 1
  const auto& planes = surface.planes;
  const float* inside = sample.inside.data();
  const auto visible =
      products<4>({planes[0].data(), planes[1].data(), planes[2].data(), surface.energy.data()},
                  {inside, inside, inside, inside}, surface.padded());
  const auto common =
      products<3>({planes[0].data(), planes[1].data(), planes[2].data()},
                  {sample.planes[0].data(), sample.planes[1].data(), sample.planes[2].data()},
                  surface.padded());
  double t = 0, s = 0, ts = 0;
  const double tt = visible[kChannels];
  for (int c = 0; c < kChannels; ++c) {
    t += visible[c];
    s += sample.means[c] * static_cast<double>(sample.visible);
    ts += common[c];
    // Outside, the sample holds its mean.
    if (sample.visible < sample.points)
      ts -=
          sample.means[c] * (std::accumulate(planes[c].begin(), planes[c].end(), 0.0) - visible[c]);
  }
  const double count = kChannels * static_cast<double>(sample.visible);
  const double variance = tt / count - t / count * (t / count);
  const double covariance = ts / count - t / count * (s / count);
  const double factor = std::clamp((covariance + kPrior) / (variance + kPrior), 0.65, 1.5);
  return {static_cast<float>(factor), static_cast<float>(s / count - factor * t / count)};
}

double best_blocks_residual(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  constexpr float kWorst = 60 * 60;  // [grey^2] of one value
  const kernels::Gain gain = fit_gain(surface, sample);
  thread_local std::vector<float> squares;
  squares.assign(surface.padded(), 0.f);
  for (int c = 0; c < kChannels; ++c)
    kernels::add_capped_squares(surface.planes[c].data(), sample.planes[c].data(),
                                sample.inside.data(), gain, kWorst,
                                static_cast<int>(surface.padded()), squares.data());
  std::vector<float> means;
  int begin = 0;
  for (const int end : surface.block_ends) {
    float total = 0, count = 0;
    for (int i = begin; i < end; ++i) {
      total += squares[i];
      count += sample.inside[i];
    }
    if (count >= 4) means.push_back(total / (kChannels * count));
    begin = end;
  }
  if (means.empty()) return kNoFit;
  std::sort(means.begin(), means.end());
  const std::size_t best = (means.size() * 5 + 7) / 8;
  const double total =
      std::accumulate(means.begin(), means.begin() + static_cast<std::ptrdiff_t>(best), 0.0);
  return std::log(std::sqrt(total / static_cast<double>(best)) + 3);
}

double gradient_agreement(const SurfaceTemplate& surface, const SurfaceSample& sample,
                          const cv::Mat& edges, const Pose2D& pose) {
  thread_local std::vector<float> agreements;
  agreements.resize(surface.padded());
  kernels::edge_agreements(
      view_of(edges), {surface.x.data(), surface.y.data(), static_cast<int>(surface.padded())},
      surface.gradient_x.data(), surface.gradient_y.data(), placement_of(pose), agreements.data());
  return product(agreements, sample.inside.data()) /
         (kEdgeScale * (surface.gradient_total + static_cast<double>(surface.size())));
}

}  // namespace

Evidence gather_evidence(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose) {
  thread_local PoseSample sample;
  sample.read(object, scene, pose, 1);
  return gather_evidence(object, scene, pose, sample);
}

Evidence gather_evidence(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose,
                         const PoseSample& sample) {
  constexpr double kNoise = 9;  // [grey^2]
  const SurfaceTemplate& surface = object.surface;
  const SurfaceSample& seen = sample.surface;
  Evidence evidence;
  evidence.contour = contour_agreement(object.contour, sample.contour);
  evidence.found = contour_found(object.contour, sample.contour);
  evidence.texture = surface.texture();
  evidence.visible = static_cast<double>(seen.visible) /
                     static_cast<double>(std::max<std::size_t>(1, surface.size()));
  if (!seen.suffices()) return evidence;
  evidence.cast = sample.cast.size();
  evidence.gradient = gradient_agreement(surface, seen, scene.edges, pose);
  evidence.best_blocks = best_blocks_residual(surface, seen);
  evidence.histogram = overlap(surface.histogram, chroma_histogram(seen.planes, seen.inside));
  evidence.projected = surface.correlation(sample.remainder, kNoise);
  evidence.unexplained = std::log(std::sqrt(surface.unexplained(sample.remainder)) + 2);
  return evidence;
}

double log_odds(const Evidence& evidence, double area) {
  // Fitted by logistic regression to true and false poses in drawn scenes, the discount for clutter
  // (clutter.hpp) among the terms. Of what is hardly larger than its edge, the edge must be found
  // the more, and the gradients inside are those of the background.
  constexpr double kLargeArea = 1800;  // [px] beyond it size no longer guards against chance
  constexpr double kSmallArea = 700;   // [px] below it other weights hold
  static const double kCast = getenv("CAST") ? atof(getenv("CAST")) : 5;
  const double small = std::max(0.0, std::log(kSmallArea / area));
  return 18.9 * evidence.found + 17.3 * evidence.gradient - 4.28 * evidence.best_blocks +
         6.68 * evidence.histogram + 9.35 * evidence.projected - 8.29 * evidence.texture +
         0.99 * std::log(std::min(area, kLargeArea)) - 16.5 * (1 - evidence.visible) - kCast * evidence.cast - 12.4 +
         small *
             (1.17 + 12.35 * evidence.found - 23.8 * evidence.gradient -
              4.32 * evidence.best_blocks - 4.09 * evidence.histogram + 6.23 * evidence.projected);
}

double rendering_odds(const Evidence& evidence, const Rendered& rendered, double area) {
  // Fitted by logistic regression to the same poses after log_odds() and the discount for clutter;
  // less .85, since a right place at a wrong angle is wrong, too. Other brightness speaks against
  // the object, but exposure may change as well.
  constexpr double kBrighter = 0.4;
  return 4.85 - 4.22 * rendered.misfit - 6.35 * std::min(std::abs(rendered.brightness), kBrighter) -
         0.89 * evidence.found + 1.38 * evidence.best_blocks + 3.07 * evidence.histogram -
         1.95 * evidence.projected + 0.37 * std::log(area);
}

double rotation_odds(const Evidence& evidence) {
  // Fitted by logistic regression to right and wrong rotations at the same place.
  return 39 * evidence.contour + 5 * evidence.projected + 7 * evidence.gradient -
         17 * evidence.unexplained;
}

double rotation_odds(const Evidence& evidence, double misfit) {
  // Fitted likewise.
  return 57 * evidence.contour + 12 * evidence.gradient - 10.7 * misfit;
}

}  // namespace mbncc
