// SPDX-License-Identifier: BSD-3-Clause
#include "numeric/order_statistics.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace mbncc::numeric {
namespace {

constexpr std::size_t kFew = 200;  // values that are sorted directly
constexpr unsigned kBins = 1024;

// Integers in the order of their floats, because a float's bits increase with its magnitude.
std::int32_t key_of(float value) {
  std::int32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits ^ ((bits >> 31) & 0x7fffffff);
}

// Radix selection: counts values by the upper bits of their keys, which leaves few to sort.
class KeyHistogram {
 public:
  explicit KeyHistogram(const std::vector<float>& values) : values_(values) {
    std::int32_t low = key_of(values[0]), high = low;
    for (const float value : values) {
      const std::int32_t key = key_of(value);
      low = std::min(low, key);
      high = std::max(high, key);
    }
    lowest_ = static_cast<std::uint32_t>(low);
    const std::uint32_t range = static_cast<std::uint32_t>(high) - lowest_;
    while ((range >> shift_) >= kBins) ++shift_;
    for (const float value : values) ++counts_[bin_of(value)];
  }

  // The value of this rank.
  float at(std::size_t rank) const {
    unsigned bin = 0;
    for (; rank >= counts_[bin]; ++bin) rank -= counts_[bin];
    std::vector<float> candidates;
    candidates.reserve(counts_[bin]);
    for (const float value : values_)
      if (bin_of(value) == bin) candidates.push_back(value);
    const auto position = candidates.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(candidates.begin(), position, candidates.end());
    return *position;
  }

 private:
  unsigned bin_of(float value) const {
    return (static_cast<std::uint32_t>(key_of(value)) - lowest_) >> shift_;
  }

  const std::vector<float>& values_;
  std::uint32_t lowest_ = 0;
  unsigned shift_ = 0;
  std::array<std::uint32_t, kBins> counts_{};
};

}  // namespace

float quantile(std::vector<float>& values, double q) {
  if (values.empty()) return 0;
  const auto rank = std::min(values.size() - 1, static_cast<std::size_t>(q * values.size()));
  if (values.size() > kFew) return KeyHistogram(values).at(rank);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace mbncc::numeric
