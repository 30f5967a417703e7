// SPDX-License-Identifier: BSD-3-Clause
// Weighted median.
#pragma once

#include <utility>
#include <vector>

namespace mbncc::numeric {

using Weighted = std::pair<float, float>;  ///< value, weight > 0

/// The least value that half of the weight does not exceed; 0 for none. Reorders `values`.
float weighted_median(std::vector<Weighted>& values);

}  // namespace mbncc::numeric
