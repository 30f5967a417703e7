// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/weighted_median.hpp"

#include <algorithm>
#include <numeric>

namespace mbncc::numeric {
namespace {

double weight_of(std::vector<Weighted>::const_iterator first,
                 std::vector<Weighted>::const_iterator last) {
  return std::accumulate(first, last, 0.0,
                         [](double sum, const Weighted& one) { return sum + one.second; });
}

}  // namespace

// Uses selection, so that not all values have to be sorted.
float weighted_median(std::vector<Weighted>& values) {
  if (values.empty()) return 0;
  double left = weight_of(values.begin(), values.end()) / 2;
  auto first = values.begin(), last = values.end();
  while (last - first > 1) {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last);
    const double below = weight_of(first, middle);
    if (below >= left) {
      last = middle;
    } else {
      left -= below;
      first = middle;
      if (middle->second >= left || middle + 1 == last) break;
      left -= middle->second;
      ++first;
    }
  }
  return first->first;
}

}  // namespace mbncc::numeric
