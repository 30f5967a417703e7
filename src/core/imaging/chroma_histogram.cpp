// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/chroma_histogram.hpp"

#include <algorithm>
#include <cmath>

#include "simd/point_kernels.hpp"

namespace mbncc::imaging {
namespace {

using Logarithms = std::array<float, 256>;

const Logarithms& logarithms() {
  static const Logarithms table = [] {
    constexpr float kDark = 12;  // [grey levels] added before taking them
    Logarithms values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = std::log(static_cast<float>(i) + kDark);
    return values;
  }();
  return table;
}

}  // namespace

ChromaHistogram chroma_histogram(const std::array<std::vector<float>, 3>& planes,
                                 const std::vector<float>& inside) {
  constexpr float kReach = 0.6f;
  thread_local std::vector<std::int32_t> cells;
  cells.resize(inside.size());
  kernels::chroma_cells({logarithms().data(), kReach, kChromaSide}, planes[0].data(),
                        planes[1].data(), planes[2].data(), static_cast<int>(inside.size()),
                        cells.data());
  // Neighbours often fall into the same cell; interleaved counters avoid dependent additions.
  std::array<ChromaHistogram, 4> parts{};
  for (std::size_t i = 0; i < inside.size(); i += parts.size())
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k][cells[i + k]] += inside[i + k];
  ChromaHistogram histogram{};
  float total = 0;
  for (std::size_t cell = 0; cell < histogram.size(); ++cell) {
    for (const auto& part : parts) histogram[cell] += part[cell];
    total += histogram[cell];
  }
  for (auto& share : histogram) share /= std::max(1.f, total);
  return histogram;
}

double overlap(const ChromaHistogram& a, const ChromaHistogram& b) {
  float common = 0;
  for (std::size_t k = 0; k < a.size(); ++k) common += std::min(a[k], b[k]);
  return common;
}

}  // namespace mbncc::imaging
