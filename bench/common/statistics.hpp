// SPDX-License-Identifier: BSD-3-Clause
// Small statistics of measured series.
#pragma once

#include <vector>

namespace mbncc::bench {

/// Value below which `percent` of the series lies, linear between neighbours; NaN when empty.
double percentile(std::vector<double> series, double percent);

double median(std::vector<double> series);

/// NaN when empty.
double mean(const std::vector<double>& series);

}  // namespace mbncc::bench
