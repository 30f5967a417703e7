// SPDX-License-Identifier: BSD-3-Clause
// Colours without regard to brightness.
#pragma once

#include <array>
#include <vector>

namespace mbncc {

constexpr int kChromaSide = 8;

/// Shares of (ln R/G, ln B/G), tamed where it is dark.
using ChromaHistogram = std::array<float, kChromaSide * kChromaSide>;

/// Of the points where `inside` is 1 (elsewhere 0). `planes` are b, g, r.
ChromaHistogram chroma_histogram(const std::array<std::vector<float>, 3>& planes,
                                 const std::vector<float>& inside);

/// Common part [0..1].
double overlap(const ChromaHistogram& a, const ChromaHistogram& b);

}  // namespace mbncc
