// SPDX-License-Identifier: BSD-3-Clause
// Histogram of chroma, which is independent of brightness.
#pragma once

#include <array>
#include <vector>

namespace mbncc::imaging {

constexpr int kChromaSide = 8;

/// Fractions of pixels per cell of (ln R/G, ln B/G), regularised in dark areas.
using ChromaHistogram = std::array<float, kChromaSide * kChromaSide>;

/// Histogram of the points where `inside` is 1 (0 elsewhere). `planes` are b, g, r.
ChromaHistogram chroma_histogram(const std::array<std::vector<float>, 3>& planes,
                                 const std::vector<float>& inside);

/// Histogram intersection [0..1].
double overlap(const ChromaHistogram& a, const ChromaHistogram& b);

}  // namespace mbncc::imaging
