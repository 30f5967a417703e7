// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terminal/progress.hpp"

#include <unistd.h>

#include <cmath>
#include <iostream>
#include <utility>

namespace mbncc::cli {
namespace {

constexpr double kPatience = 2;   // [s] before the first output
constexpr double kRefresh = 0.2;  // [s] between two updates
constexpr int kWidth = 30;        // [characters] of the bar
constexpr const char* kEraseLine = "\r\x1b[K";

}  // namespace

Progress::Progress(std::string what, std::size_t count, Where where)
    : Progress(std::move(what), count, std::cerr,
               ::isatty(STDERR_FILENO) == 1 && (where == kAlways || ::isatty(STDOUT_FILENO) == 0),
               kPatience) {}

Progress::Progress(std::string what, std::size_t count, std::ostream& out, bool terminal,
                   double patience)
    : what_(std::move(what)), count_(count), out_(out), terminal_(terminal), patience_(patience) {}

Progress::~Progress() {
  if (drawn_at_ >= 0) out_ << kEraseLine << std::flush;
}

double Progress::seconds() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void Progress::step() {
  ++done_;
  if (!terminal_ || seconds() < patience_) return;
  if (drawn_at_ >= 0 && seconds() - drawn_at_ < kRefresh && done_ < count_) return;
  draw();
}

void Progress::draw() {
  drawn_at_ = seconds();
  const double part = count_ == 0 ? 1 : static_cast<double>(done_) / static_cast<double>(count_);
  const int full = static_cast<int>(std::lround(kWidth * part));
  const auto left = std::lround(seconds() * (1 - part) / part);
  out_ << kEraseLine << '[' << std::string(static_cast<std::size_t>(full), '#')
       << std::string(static_cast<std::size_t>(kWidth - full), '-') << "] " << what_ << ' ' << done_
       << " of " << count_ << ", " << left << " s left" << std::flush;
}

}  // namespace mbncc::cli
