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

void add_residuals(const SurfaceTemplate& surface, const SurfaceSample& sample,
                   Evidence& evidence) {
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
  double sum = 0, count = 0;
  std::vector<double> means;
  for (int k = 0; k < surface.blocks; ++k) {
    sum += sums[k];
    count += counts[k];
    if (counts[k] >= 12) means.push_back(sums[k] / counts[k]);
  }
  evidence.residual = std::log(std::sqrt(sum / count) + 3);
  if (means.empty()) return;
  std::sort(means.begin(), means.end());
  const std::size_t best = (means.size() * 5 + 7) / 8;
  double total = 0;
  for (std::size_t k = 0; k < best; ++k) total += means[k];
  evidence.best_blocks = std::log(std::sqrt(total / static_cast<double>(best)) + 3);
}

void add_chroma(const SurfaceTemplate& surface, const SurfaceSample& sample, Evidence& evidence) {
  constexpr double kPrior = 0.003;
  std::array<float, SurfaceTemplate::kHistogramSide * SurfaceTemplate::kHistogramSide> cells{};
  double sum_x = 0, sum_y = 0, square = 0, product = 0, template_square = 0, template_x = 0,
         template_y = 0;
  const double count = static_cast<double>(sample.visible);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    if (!sample.inside[i]) continue;
    const cv::Point2f value = chroma(sample.planes[0][i], sample.planes[1][i], sample.planes[2][i]);
    cells[chroma_cell(value)] += static_cast<float>(1 / count);
    const double tx = surface.chroma_x[i], ty = surface.chroma_y[i];
    sum_x += value.x;
    sum_y += value.y;
    square += value.x * value.x + value.y * value.y;
    product += value.x * tx + value.y * ty;
    template_square += tx * tx + ty * ty;
    template_x += tx;
    template_y += ty;
  }
  const double energy = square - (sum_x * sum_x + sum_y * sum_y) / count;
  const double common = product - (sum_x * template_x + sum_y * template_y) / count;
  const double prior = kPrior * count;
  evidence.chroma = common / std::sqrt((std::max(0.0, energy) + prior) * (template_square + prior));
  for (std::size_t k = 0; k < cells.size(); ++k)
    evidence.histogram += std::min(cells[k], surface.histogram[k]);
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
  add_residuals(surface, sample, evidence);
  add_chroma(surface, sample, evidence);
  evidence.projected = surface.projected_correlation(sample, kNoise);
  return evidence;
}

double log_odds(const Evidence& evidence, double area) {
  return 0.608 * (18.98 * evidence.contour + 6.21 * evidence.gradient -
                  5.77 * evidence.best_blocks + 3.76 * evidence.histogram + 6.03 * evidence.chroma +
                  1.19 * evidence.projected + 1.50 * std::log(area) - 9.61) -
         1.64;
}

}  // namespace mbncc
