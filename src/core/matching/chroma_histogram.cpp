#include "matching/chroma_histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/core.hpp>

#include "polar/point_kernels.hpp"

namespace mbncc {
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

/// (ln R/G, ln B/G) of a point.
cv::Point2f chroma_at(const std::array<std::vector<float>, 3>& planes, std::size_t i) {
  const auto logarithm = [&](std::size_t channel) {
    return logarithms()[static_cast<std::size_t>(planes[channel][i] + 0.5f)];
  };
  return {logarithm(2) - logarithm(1), logarithm(0) - logarithm(1)};
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
  // Neighbours often fall into one cell: apart, their additions need not wait for each other.
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

double worst_chroma_difference(const std::array<std::vector<float>, 3>& expected,
                               const std::array<std::vector<float>, 3>& seen,
                               const std::vector<float>& inside,
                               const std::vector<int>& block_ends) {
  constexpr float kMost = 0.36f;  // of one squared difference
  std::vector<double> means;
  std::size_t begin = 0;
  for (const int block_end : block_ends) {
    const auto end = static_cast<std::size_t>(block_end);
    double sum = 0, count = 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (inside[i] == 0) continue;
      const cv::Point2f difference = chroma_at(expected, i) - chroma_at(seen, i);
      sum += std::min(kMost, difference.dot(difference));
      ++count;
    }
    if (count >= 4) means.push_back(sum / count);
    begin = end;
  }
  if (means.empty()) return 0;
  std::sort(means.rbegin(), means.rend());
  const std::size_t worst = std::max<std::size_t>(1, means.size() * 3 / 8);
  const auto last = means.begin() + static_cast<std::ptrdiff_t>(worst);
  return std::sqrt(std::accumulate(means.begin(), last, 0.0) / static_cast<double>(worst));
}

double overlap(const ChromaHistogram& a, const ChromaHistogram& b) {
  float common = 0;
  for (std::size_t k = 0; k < a.size(); ++k) common += std::min(a[k], b[k]);
  return common;
}

}  // namespace mbncc
