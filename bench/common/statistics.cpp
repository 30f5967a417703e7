// SPDX-License-Identifier: BSD-3-Clause
#include "common/statistics.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace mbncc::bench {

double percentile(std::vector<double> series, double percent) {
  if (series.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(series.begin(), series.end());
  const double at = percent / 100 * static_cast<double>(series.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const auto above = std::min(below + 1, series.size() - 1);
  return series[below] + (at - static_cast<double>(below)) * (series[above] - series[below]);
}

double median(std::vector<double> series) {
  return percentile(std::move(series), 50);
}

double mean(const std::vector<double>& series) {
  if (series.empty()) return std::numeric_limits<double>::quiet_NaN();
  return std::accumulate(series.begin(), series.end(), 0.0) / static_cast<double>(series.size());
}

}  // namespace mbncc::bench
