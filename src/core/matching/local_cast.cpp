#include "matching/local_cast.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace mbncc {
namespace {

constexpr int kChannels = SurfaceTemplate::kChannels;
using Means = std::array<float, kChannels>;

/// Of the points [begin, end) that lie in the picture, `count` of them.
Means means_of(const std::array<std::vector<float>, kChannels>& planes,
               const std::vector<float>& inside, int begin, int end, float count) {
  Means means{};
  for (int c = 0; c < kChannels; ++c)
    for (int i = begin; i < end; ++i) means[c] += planes[c][i] * inside[i] / count;
  return means;
}

bool is_told_by(const Means& means) {
  constexpr float kDark = 24, kClipped = 245;
  return std::all_of(means.begin(), means.end(),
                     [&](float mean) { return mean >= kDark && mean <= kClipped; });
}

double apart(const ColourCast& a, const ColourCast& b) {
  return std::hypot(a.blue - b.blue, a.red - b.red);
}

/// Mean of the half of `casts` (not empty) that lies closest about one of them.
ColourCast tightest_half(const std::vector<ColourCast>& casts) {
  const auto half = static_cast<std::ptrdiff_t>(casts.size() / 2 + 1);
  double least = std::numeric_limits<double>::infinity();
  std::vector<ColourCast> sorted = casts, tightest;
  for (const auto& one : casts) {
    const auto nearer = [&](const ColourCast& a, const ColourCast& b) {
      return apart(a, one) < apart(b, one);
    };
    std::nth_element(sorted.begin(), sorted.begin() + (half - 1), sorted.end(), nearer);
    const double reach = apart(sorted[half - 1], one);
    if (reach >= least) continue;
    least = reach;
    tightest.assign(sorted.begin(), sorted.begin() + half);
  }
  ColourCast mean;
  for (const auto& cast : tightest) {
    mean.blue += cast.blue / static_cast<double>(half);
    mean.red += cast.red / static_cast<double>(half);
  }
  return mean;
}

}  // namespace

std::optional<ColourCast> local_cast(const SurfaceTemplate& surface, const SurfaceSample& sample) {
  constexpr std::size_t kEnough = 3;
  thread_local std::vector<ColourCast> casts;
  casts.clear();
  int begin = 0;
  for (const int end : surface.block_ends) {
    float count = 0;
    for (int i = begin; i < end; ++i) count += sample.inside[i];
    if (count > 0) {
      const Means seen = means_of(sample.planes, sample.inside, begin, end, count);
      const Means learned = means_of(surface.planes, sample.inside, begin, end, count);
      if (is_told_by(seen) && is_told_by(learned)) {
        const float green = seen[1] / learned[1];
        casts.push_back(
            {std::log(seen[0] / learned[0] / green), std::log(seen[2] / learned[2] / green)});
      }
    }
    begin = end;
  }
  if (casts.size() < kEnough) return std::nullopt;
  return tightest_half(casts);
}

ColourCast bounded(const ColourCast& cast) {
  constexpr double kMost = 0.3;
  return {std::clamp(cast.blue, -kMost, kMost), std::clamp(cast.red, -kMost, kMost)};
}

void take_out(const ColourCast& cast, SurfaceSample& sample) {
  const cv::Vec3d gains = cast.gains();
  for (int c = 0; c < kChannels; ++c) {
    const auto factor = static_cast<float>(1 / gains[c]);
    for (auto& value : sample.planes[c]) value *= factor;
    sample.means[c] *= factor;
  }
}

}  // namespace mbncc
