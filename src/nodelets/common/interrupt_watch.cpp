// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/interrupt_watch.hpp"

#include <ros/init.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <mutex>
#include <utility>

namespace mbncc::nodelets {
namespace {

constexpr std::chrono::milliseconds kPollInterval{50};  // between two checks for an interrupt

// Written in any thread that receives the signal, read in the watches' threads; std::sig_atomic_t
// is only safe within one thread.
std::atomic<bool> interrupted{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler must not wait");

void note_interrupt(int) {
  interrupted = true;
}

/// Replaces roscpp's SIGINT handler for the first watch of the process and restores it after the
/// last one.
class SharedHandler {
 public:
  void enter() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (watches_++ > 0) return;
    struct sigaction ours {};
    ours.sa_handler = note_interrupt;
    sigaction(SIGINT, &ours, &previous_action_);
  }

  /// Returns true for the last watch.
  bool leave() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (--watches_ > 0) return false;
    sigaction(SIGINT, &previous_action_, nullptr);
    return true;
  }

 private:
  std::mutex mutex_;
  int watches_ = 0;
  struct sigaction previous_action_ {};
};

SharedHandler shared_handler;

}  // namespace

InterruptWatch::InterruptWatch(std::function<void()> on_interrupt)
    : on_interrupt_(std::move(on_interrupt)) {
  shared_handler.enter();
  watcher_ = std::thread([this] { watch(); });
}

InterruptWatch::~InterruptWatch() {
  stopped_ = true;
  watcher_.join();
}

void InterruptWatch::watch() {
  while (!stopped_ && !interrupted) std::this_thread::sleep_for(kPollInterval);
  const bool was_interrupted = interrupted;
  if (was_interrupted) on_interrupt_();
  const bool last = shared_handler.leave();
  if (was_interrupted && last) ros::requestShutdown();
}

}  // namespace mbncc::nodelets
