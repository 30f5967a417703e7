// SPDX-License-Identifier: BSD-3-Clause
// Independent random streams from one seed.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

namespace mbncc::sim {

/// splitmix64: neighbouring seeds and streams give unrelated states.
inline std::uint64_t mix(std::uint64_t seed, std::uint64_t stream) {
  std::uint64_t z = seed + 0x9e3779b97f4a7c15ULL * (stream + 1);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

/// Generator number `stream` of `seed`.
inline cv::RNG generator(std::uint64_t seed, std::uint64_t stream) {
  return cv::RNG(mix(mix(seed, 0), stream));
}

}  // namespace mbncc::sim
