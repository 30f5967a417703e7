// SPDX-License-Identifier: BSD-3-Clause
// A short queue between threads: when it is full, a new item displaces the oldest one, so writers
// never wait for a slow reader.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace mbncc::nodelets {

template <class Item>
class Mailbox {
 public:
  /// `size` is the number of items that can wait, at least 1. With 1, a new item replaces the
  /// waiting one.
  explicit Mailbox(std::size_t size = 1) : size_(size) {}

  /// Appends an item. Returns true if it displaced the oldest waiting item.
  bool put(Item item) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool full = items_.size() >= size_;
    if (full) items_.pop_front();
    items_.push_back(std::move(item));
    filled_.notify_one();
    return full;
  }

  /// Waits for an item, and removes and returns the oldest one; none after close().
  std::optional<Item> take() {
    std::unique_lock<std::mutex> lock(mutex_);
    filled_.wait(lock, [this] { return closed_ || !items_.empty(); });
    if (closed_) return {};
    std::optional<Item> item = std::move(items_.front());
    items_.pop_front();
    return item;
  }

  /// Drops the items that were not taken yet.
  void clear() {
    const std::lock_guard<std::mutex> lock(mutex_);
    items_.clear();
  }

  /// Makes current and later calls of take() return none.
  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    filled_.notify_all();
  }

 private:
  std::mutex mutex_;
  std::condition_variable filled_;
  const std::size_t size_;
  std::deque<Item> items_;
  bool closed_ = false;
};

}  // namespace mbncc::nodelets
