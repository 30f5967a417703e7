// SPDX-License-Identifier: BSD-3-Clause
// Cache of padded data of an image, shared by all searches of that image.
#pragma once

#include <memory>
#include <mutex>

namespace mbncc::scene {

/// `Padded` has fill(source, margin), which reuses its memory, and margin(). Thread-safe.
template <class Padded>
class PaddedCache {
 public:
  /// The data with a margin of at least `margin` [px]. `source` must be the same image until
  /// forget().
  template <class Source>
  std::shared_ptr<const Padded> get(const Source& source, int margin) {
    constexpr int kGrain = 16;  // steps of the margin, so that larger objects seldom need more
    const int wanted = (margin + kGrain - 1) / kGrain * kGrain;
    const std::lock_guard<std::mutex> lock(filling_);
    if (valid_ && padded_->margin() >= wanted) return padded_;
    const bool in_use = valid_;  // other searches may still read the data with the smaller margin
    valid_ = false;              // until filled: memory may run out
    if (!padded_ || in_use) padded_ = std::make_shared<Padded>();
    padded_->fill(source, wanted);
    valid_ = true;
    return padded_;
  }

  /// Call before requests for another image, when data of the old one is no longer used.
  void forget() { valid_ = false; }

 private:
  std::mutex filling_;
  std::shared_ptr<Padded> padded_;
  bool valid_ = false;
};

}  // namespace mbncc::scene
