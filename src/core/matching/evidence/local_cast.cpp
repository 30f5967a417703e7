// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/local_cast.hpp"

#include <algorithm>
#include <limits>

namespace mbncc::evidence {
namespace {

/// Whether a block's mean colour is neither dark nor clipped in any channel.
bool is_usable(const templates::BlockSums::Channels& sums, double count) {
  constexpr double kDark = 24, kClipped = 245;
  return std::all_of(sums.begin(), sums.end(),
                     [&](double sum) { return sum >= kDark * count && sum <= kClipped * count; });
}

double square_apart(const ColourCast& a, const ColourCast& b) {
  const double blue = a.blue - b.blue, red = a.red - b.red;
  return blue * blue + red * red;
}

/// Mean of the most compact half of `casts` (not empty).
ColourCast tightest_half(const std::vector<ColourCast>& casts) {
  const std::size_t half = casts.size() / 2 + 1;
  double least = std::numeric_limits<double>::infinity();
  ColourCast middle;
  std::vector<double> squares(casts.size());
  const auto reach_about = [&](const ColourCast& one) {
    for (std::size_t i = 0; i < casts.size(); ++i) squares[i] = square_apart(casts[i], one);
    const auto last = squares.begin() + static_cast<std::ptrdiff_t>(half - 1);
    std::nth_element(squares.begin(), last, squares.end());
    return *last;
  };
  for (const auto& one : casts) {
    const double reach = reach_about(one);
    if (reach >= least) continue;
    least = reach;
    middle = one;
  }
  ColourCast sum;
  std::size_t count = 0;
  for (const auto& cast : casts) {
    if (square_apart(cast, middle) > least) continue;
    sum.blue += cast.blue;
    sum.red += cast.red;
    ++count;
  }
  return {sum.blue / static_cast<double>(count), sum.red / static_cast<double>(count)};
}

}  // namespace

std::optional<ColourCast> local_cast(const std::vector<templates::BlockSums>& blocks) {
  std::vector<ColourCast> casts;
  for (const auto& [count, learned, seen, learned_square, seen_square, product] : blocks) {
    if (count == 0 || !is_usable(learned, count) || !is_usable(seen, count)) continue;
    const double green = seen[1] / learned[1];
    casts.push_back(
        {std::log(seen[0] / learned[0] / green), std::log(seen[2] / learned[2] / green)});
  }
  if (casts.empty()) return std::nullopt;
  return tightest_half(casts);
}

ColourCast bounded(const ColourCast& cast) {
  constexpr double kMost = 0.3;
  return {std::clamp(cast.blue, -kMost, kMost), std::clamp(cast.red, -kMost, kMost)};
}

void remove_cast(const ColourCast& cast, templates::SurfaceSample& sample) {
  constexpr float kWhite = 255;
  const cv::Vec3d gains = cast.gains();
  for (int c = 0; c < templates::SurfaceTemplate::kChannels; ++c) {
    const auto factor = static_cast<float>(1 / gains[c]);
    for (auto& value : sample.planes[c]) value = std::min(kWhite, value * factor);
  }
}

void remove_cast(const ColourCast& cast, std::vector<templates::BlockSums>& blocks) {
  const cv::Vec3d gains = cast.gains();
  for (auto& block : blocks)
    for (int c = 0; c < templates::SurfaceTemplate::kChannels; ++c) {
      block.seen[c] /= gains[c];
      block.product[c] /= gains[c];
      block.seen_square[c] /= gains[c] * gains[c];
    }
}

}  // namespace mbncc::evidence
