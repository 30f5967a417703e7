// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/colour_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <utility>

#include "matching/evidence/gain_offset.hpp"
#include "numeric/fixed_random_state.hpp"
#include "numeric/order_statistics.hpp"
#include "numeric/weighted_median.hpp"

namespace mbncc::evidence {
namespace {

constexpr int kChannels = templates::SurfaceTemplate::kChannels;
constexpr int kParts = 7;
using Planes = std::array<std::vector<float>, kChannels>;

float brightness(const Planes& planes, std::size_t i) {
  return (planes[0][i] + planes[1][i] + planes[2][i]) / kChannels;
}

/// (ln R/G, ln B/G), with `dark` [grey levels] added to each channel to bound noise in dark
/// colours.
cv::Point2f chroma(float blue, float green, float red, float dark) {
  const float by = std::log(green + dark);
  return {std::log(red + dark) - by, std::log(blue + dark) - by};
}

/// Index of each point's part of uniform colour. Brightness has less weight than chroma, because
/// light changes it.
std::vector<int> parts_of(const templates::SurfaceTemplate& surface) {
  constexpr float kDark = 20, kChroma = 2, kBrightness = 0.3f;
  const int count = static_cast<int>(surface.size());
  const auto& planes = surface.planes;
  cv::Mat colours(count, 3, CV_32F), labels;
  for (int i = 0; i < count; ++i) {
    const cv::Point2f c = kChroma * chroma(planes[0][i], planes[1][i], planes[2][i], kDark);
    auto* row = colours.ptr<float>(i);
    row[0] = c.x;
    row[1] = c.y;
    row[2] = kBrightness * std::log(brightness(planes, i) + kDark);
  }
  const numeric::FixedRandomState fixed;
  cv::kmeans(colours, std::min(kParts, count), labels,
             {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 1e-3}, 2, cv::KMEANS_PP_CENTERS);
  return {labels.begin<int>(), labels.end<int>()};
}

/// Chroma differences and weights of the visible points of a part.
struct VisiblePart {
  std::vector<numeric::Weighted> red, blue;
  double points = 0, weight = 0;

  /// Whether enough of the part is visible.
  bool suffices() const {
    constexpr double kEnough = 0.3;  // least mean weight of the part's points
    return weight >= kEnough * points;
  }
};

/// The chroma difference of a part.
struct PartDifference {
  double difference;
  double points;
};

/// Largest difference that parts of at least kShare of `all` points reach together, because the
/// colours of a small print can be divided into several parts.
double worst_of_share(std::vector<PartDifference> parts, std::size_t all) {
  constexpr double kShare = 0.045;
  std::sort(parts.begin(), parts.end(), [](const PartDifference& a, const PartDifference& b) {
    return a.difference > b.difference;
  });
  double points = 0;
  for (const auto& part : parts) {
    points += part.points;
    if (points >= kShare * static_cast<double>(all)) return part.difference;
  }
  return 0;
}

/// Chroma differences `off` of the points, by part.
std::vector<VisiblePart> by_part(const std::vector<int>& part_of,
                                 const std::vector<cv::Point2f>& off,
                                 const std::vector<float>& weights) {
  std::vector<VisiblePart> parts(1 + *std::max_element(part_of.begin(), part_of.end()));
  for (std::size_t i = 0; i < part_of.size(); ++i) {
    VisiblePart& part = parts[part_of[i]];
    ++part.points;
    if (weights[i] == 0) continue;
    part.weight += weights[i];
    part.red.emplace_back(off[i].x, weights[i]);
    part.blue.emplace_back(off[i].y, weights[i]);
  }
  return parts;
}

/// `off` minus the contribution of an unknown fraction of background.
cv::Point2f unexplained(const cv::Point2f& off, const cv::Point2f& ground_off) {
  constexpr float kSame = 0.01f;  // chroma difference; more similar backgrounds explain nothing
  const float square = ground_off.dot(ground_off);
  if (square < kSame * kSame) return off;
  return off - std::clamp(off.dot(ground_off) / square, 0.f, 1.f) * ground_off;
}

}  // namespace

ColourParts::ColourParts(const templates::SurfaceTemplate& surface,
                         const templates::ContourTemplate& contour, const cv::Vec3f& ground)
    : ground_(ground) {
  constexpr std::size_t kMost = 24;  // contour points used per point
  if (surface.size() < kParts || contour.size() == 0) return;
  part_ = parts_of(surface);
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const std::vector<int> beside = templates::points_beside(contour, {surface.x[i], surface.y[i]});
    const std::size_t count = std::min(kMost, beside.size());
    beside_.emplace_back();
    for (std::size_t k = 0; k < count; ++k)
      beside_.back().push_back(beside[k * beside.size() / count]);
  }
}

/// Weights [0..1] of the points, from the fraction of nearby contour points that are found.
std::vector<float> ColourParts::weights_from_contour(
    const templates::SurfaceSample& sample, const templates::ContourSample& contour) const {
  constexpr float kNone = 0.45f, kFull = 0.8f;
  std::vector<float> weights(sample.inside.size(), 0.f), clear(contour.seen);
  for (std::size_t i = 0; i < clear.size(); ++i)
    if (!templates::is_clear(contour.response[i])) clear[i] = 0;
  for (std::size_t i = 0; i < part_.size(); ++i) {
    float found = 0, seen = 0;
    for (const int at : beside_[i]) {
      seen += contour.seen[at];
      found += clear[at];
    }
    if (seen == 0) continue;
    weights[i] = sample.inside[i] * std::clamp((found / seen - kNone) / (kFull - kNone), 0.f, 1.f);
  }
  return weights;
}

double ColourParts::worst_difference(const templates::SurfaceTemplate& surface,
                                     const templates::SurfaceSample& sample,
                                     const templates::ContourSample& contour,
                                     const cv::Vec3f& ground) const {
  constexpr float kDark = 30;       // [grey levels] in the lesson
  constexpr float kUnseen = 0.02f;  // weight, when fitting the light, without found contour points
  if (part_.empty() || !sample.suffices()) return 0;
  const std::vector<float> weights = weights_from_contour(sample, contour);
  std::vector<float> lit = sample.inside;
  for (std::size_t i = 0; i < lit.size(); ++i) lit[i] *= weights[i] + kUnseen;
  const GainOffset light = fit_gain_offset(surface.planes, sample.planes, lit);
  const float dark = kDark * static_cast<float>(light.factor);  // equal sensitivity in dim light
  const auto chroma_off = [&](const cv::Vec3f& learned, const cv::Vec3f& seen) {
    return chroma(light.of(learned[0]), light.of(learned[1]), light.of(learned[2]), dark) -
           chroma(seen[0], seen[1], seen[2], dark);
  };
  std::vector<cv::Point2f> off(surface.size());
  for (std::size_t i = 0; i < off.size(); ++i) {
    if (weights[i] == 0) continue;
    const auto colour = [i](const Planes& planes) {
      return cv::Vec3f(planes[0][i], planes[1][i], planes[2][i]);
    };
    off[i] = chroma_off(colour(surface.planes), colour(sample.planes));
  }
  const cv::Point2f ground_off = chroma_off(ground_, ground);
  std::vector<PartDifference> differences;
  for (auto& part : by_part(part_, off, weights)) {
    if (!part.suffices()) continue;
    const cv::Point2f typical(numeric::weighted_median(part.red),
                              numeric::weighted_median(part.blue));
    differences.push_back({cv::norm(unexplained(typical, ground_off)), part.points});
  }
  return worst_of_share(std::move(differences), surface.size());
}

}  // namespace mbncc::evidence
