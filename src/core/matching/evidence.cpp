#include "matching/evidence.hpp"

#include <algorithm>
#include <cmath>

#include "matching/edge_picture.hpp"

namespace mbncc {
namespace {

constexpr int kChannels = SurfaceTemplate::kChannels;

struct Gain {
  double factor = 1, offset = 0;
};

/// Gain within bounds and offset that fit the template's colours to the picture's.
Gain fit_gain(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  constexpr double kPrior = 100;  // [grey^2] pulls the gain of plain surfaces to 1
  double t = 0, s = 0, tt = 0, ts = 0;
  for (int c = 0; c < kChannels; ++c)
    for (std::size_t i = 0; i < surface.size(); ++i) {
      if (!sample.inside[i]) continue;
      const double a = surface.planes[c][i], b = sample.planes[c][i];
      t += a;
      s += b;
      tt += a * a;
      ts += a * b;
    }
  const double count = kChannels * static_cast<double>(sample.visible);
  const double variance = tt / count - t / count * (t / count);
  const double covariance = ts / count - t / count * (s / count);
  Gain gain;
  gain.factor = std::clamp((covariance + kPrior) / (variance + kPrior), 0.65, 1.5);
  gain.offset = s / count - gain.factor * t / count;
  return gain;
}

double best_blocks_residual(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  constexpr double kWorst = 60 * 60;  // [grey^2] of one value
  const Gain gain = fit_gain(surface, sample);
  std::vector<double> sums(surface.blocks, 0), counts(surface.blocks, 0);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (!sample.inside[i]) continue;
    for (int c = 0; c < kChannels; ++c) {
      const double difference =
          sample.planes[c][i] - gain.factor * surface.planes[c][i] - gain.offset;
      sums[surface.block[i]] += std::min(difference * difference, kWorst);
    }
    counts[surface.block[i]] += kChannels;
  }
  std::vector<double> means;
  for (int k = 0; k < surface.blocks; ++k) {
    if (counts[k] >= 12) means.push_back(sums[k] / counts[k]);
  }
  if (means.empty()) return kNoFit;
  std::sort(means.begin(), means.end());
  const std::size_t best = (means.size() * 5 + 7) / 8;
  double total = 0;
  for (std::size_t k = 0; k < best; ++k) total += means[k];
  return std::log(std::sqrt(total / static_cast<double>(best)) + 3);
}

double histogram_overlap(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  std::array<float, SurfaceTemplate::kHistogramSide * SurfaceTemplate::kHistogramSide> cells{};
  const float share = 1 / static_cast<float>(sample.visible);
  for (std::size_t i = 0; i < surface.size(); ++i)
    if (sample.inside[i])
      cells[chroma_cell(chroma(sample.planes[0][i], sample.planes[1][i], sample.planes[2][i]))] +=
          share;
  double overlap = 0;
  for (std::size_t k = 0; k < cells.size(); ++k)
    overlap += std::min(cells[k], surface.histogram[k]);
  return overlap;
}

double gradient_agreement(const SurfaceTemplate& surface, const SurfaceSample& sample,
                          const cv::Mat& edges, const Pose2D& pose) {
  const auto c = static_cast<float>(std::cos(pose.theta));
  const auto s = static_cast<float>(std::sin(pose.theta));
  const float c2 = c * c - s * s, s2 = 2 * c * s;
  double sum = 0;
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (surface.gradient_weight[i] <= 0 || !sample.inside[i]) continue;
    const float x = c * surface.x[i] - s * surface.y[i] + static_cast<float>(pose.x);
    const float y = s * surface.x[i] + c * surface.y[i] + static_cast<float>(pose.y);
    const auto* edge =
        edges.ptr<std::int8_t>(static_cast<int>(y + 0.5f)) + 2 * static_cast<int>(x + 0.5f);
    const float along_x = c2 * surface.gradient_x[i] - s2 * surface.gradient_y[i];
    const float along_y = s2 * surface.gradient_x[i] + c2 * surface.gradient_y[i];
    sum += surface.gradient_weight[i] * (edge[0] * along_x + edge[1] * along_y) / kEdgeScale;
  }
  return sum / (surface.gradient_total + static_cast<double>(surface.size()));
}

}  // namespace

Evidence gather_evidence(const PoseTemplate& object, const SceneLevel& scene, const Pose2D& pose) {
  constexpr double kNoise = 9;  // [grey^2]
  thread_local SurfaceSample sample;
  const SurfaceTemplate& surface = object.surface;
  surface.sample(scene, pose, sample);
  Evidence evidence;
  evidence.contour = contour_agreement(object.contour, scene.edges, pose);
  evidence.visible = static_cast<double>(sample.visible) /
                     static_cast<double>(std::max<std::size_t>(1, surface.size()));
  if (!sample.suffices()) return evidence;
  evidence.gradient = gradient_agreement(surface, sample, scene.edges, pose);
  evidence.best_blocks = best_blocks_residual(surface, sample);
  evidence.histogram = histogram_overlap(surface, sample);
  evidence.projected = surface.projected_correlation(sample, kNoise);
  return evidence;
}

double log_odds(const Evidence& evidence, double area) {
  // Fitted by logistic regression to true and false poses in drawn scenes and photographs.
  constexpr double kLargeArea = 1800;  // [px] beyond it size no longer guards against chance
  return 19 * evidence.contour + 5.5 * evidence.gradient - 6.7 * evidence.best_blocks +
         3.2 * evidence.histogram + 7.4 * evidence.projected +
         1.95 * std::log(std::min(area, kLargeArea)) - 9.3 * (1 - evidence.visible) - 11.8;
}

}  // namespace mbncc
