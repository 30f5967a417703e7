#include "matching/hidden_parts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace mbncc {
namespace {

/// By part, whether it is hidden.
std::vector<char> hidden_blocks(const std::vector<double>& residuals) {
  constexpr double kFarther = 3;  // times the residual of the better ones ...
  constexpr double kLeast = 20;   // [grey levels] ... and so much more
  std::vector<double> sorted;
  std::copy_if(residuals.begin(), residuals.end(), std::back_inserter(sorted),
               [](double residual) { return residual >= 0; });
  if (sorted.empty()) return {};
  std::sort(sorted.begin(), sorted.end());
  const double usual = sorted[sorted.size() / 2];
  std::vector<char> hidden;
  for (const double residual : residuals)
    hidden.push_back(residual > std::max(kFarther * usual, usual + kLeast));
  return hidden;
}

}  // namespace

HiddenParts::HiddenParts(const SurfaceTemplate& surface, const ContourTemplate& contour)
    : block_ends_(surface.block_ends) {
  for (std::size_t k = 0; k < contour.size(); ++k) {
    std::size_t nearest = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < surface.size(); ++i) {
      const float apart = std::hypot(contour.x[k] - surface.x[i], contour.y[k] - surface.y[i]);
      if (apart >= least) continue;
      least = apart;
      nearest = i;
    }
    const auto block =
        std::upper_bound(block_ends_.begin(), block_ends_.end(), static_cast<int>(nearest));
    block_of_contour_.push_back(static_cast<int>(block - block_ends_.begin()));
  }
}

double HiddenParts::take_out(const std::vector<double>& residuals, SurfaceSample& surface,
                             ContourSample& contour) const {
  constexpr double kMost = 0.45;  // of the points
  const auto hidden = hidden_blocks(residuals);
  auto inside = surface.inside;
  int begin = 0;
  for (std::size_t block = 0; block < hidden.size(); ++block) {
    const int end = block_ends_[block];
    if (hidden[block]) std::fill(inside.begin() + begin, inside.begin() + end, 0.f);
    begin = end;
  }
  const double left = std::accumulate(inside.begin(), inside.end(), 0.0);
  const double share = 1 - left / static_cast<double>(surface.visible);
  if (share < 1e-6 || share > kMost) return 0;
  surface.inside = std::move(inside);
  surface.forget_outside();
  for (std::size_t k = 0; k < block_of_contour_.size(); ++k)
    if (hidden[block_of_contour_[k]])
      for (auto* values : {&contour.response, &contour.seen, &contour.pull, &contour.moment})
        (*values)[k] = 0;
  return share;
}

}  // namespace mbncc
