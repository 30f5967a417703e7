// SPDX-License-Identifier: BSD-3-Clause
// One slot between threads: a new item replaces an older one, so writers never wait for a slow
// reader.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace mbncc::nodelets {

template <class Item>
class Mailbox {
 public:
  /// True if an item that was not taken yet was replaced.
  bool put(Item item) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool replaced = item_.has_value();
    item_ = std::move(item);
    filled_.notify_one();
    return replaced;
  }

  /// Waits for an item; none once closed.
  std::optional<Item> take() {
    std::unique_lock<std::mutex> lock(mutex_);
    filled_.wait(lock, [this] { return closed_ || item_.has_value(); });
    if (closed_) return {};
    return std::exchange(item_, std::nullopt);
  }

  /// Drops an item that was not taken yet.
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    item_.reset();
  }

  /// Ends every take(), now and later.
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    filled_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable filled_;
  std::optional<Item> item_;
  bool closed_ = false;
};

}  // namespace mbncc::nodelets
