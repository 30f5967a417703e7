// SPDX-License-Identifier: BSD-3-Clause
// Times of a lesson's steps.
#pragma once

#include <chrono>
#include <map>
#include <string>
#include <utility>

namespace mbncc::teaching {

/// Adds the wall time of its lifetime to timings[step], in milliseconds, also when the step throws.
class StepTimer {
 public:
  StepTimer(std::map<std::string, double>& timings, std::string step)
      : timings_(timings), step_(std::move(step)) {}
  ~StepTimer() {
    timings_[step_] += std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }
  StepTimer(const StepTimer&) = delete;
  StepTimer& operator=(const StepTimer&) = delete;

 private:
  using Clock = std::chrono::steady_clock;

  std::map<std::string, double>& timings_;
  std::string step_;
  Clock::time_point start_ = Clock::now();
};

}  // namespace mbncc::teaching
