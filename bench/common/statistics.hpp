// SPDX-License-Identifier: BSD-3-Clause
// Small statistics of measured series.
#pragma once

#include <vector>

namespace mbncc::bench {

/// Value below which `percent` of the series lies, interpolated linearly; NaN if the series is
/// empty.
double percentile(std::vector<double> series, double percent);

double median(std::vector<double> series);

/// NaN if the series is empty.
double mean(const std::vector<double>& series);

}  // namespace mbncc::bench
