// SPDX-License-Identifier: BSD-3-Clause
#include "cli/terminal/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <utility>

namespace mbncc::cli {
namespace {

constexpr double kPatience = 2;   // [s] before the first output
constexpr double kRefresh = 0.2;  // [s] between two updates
constexpr double kLeastPart = 0.01;
constexpr int kWidth = 30;  // [characters] of the bar
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
  const double part = count_ == 0 ? 1 : static_cast<double>(done_) / static_cast<double>(count_);
  show(part, what_ + ' ' + std::to_string(done_) + " of " + std::to_string(count_));
}

void Progress::show(double part, const std::string& what) {
  if (!terminal_ || seconds() < patience_) return;
  if (drawn_at_ >= 0 && seconds() - drawn_at_ < kRefresh && part < 1) return;
  draw(part, what);
}

void Progress::draw(double part, const std::string& what) {
  drawn_at_ = seconds();
  const int full = static_cast<int>(std::lround(kWidth * part));
  const auto left = std::lround(seconds() * (1 - part) / std::max(part, kLeastPart));
  out_ << kEraseLine << '[' << std::string(static_cast<std::size_t>(full), '#')
       << std::string(static_cast<std::size_t>(kWidth - full), '-') << "] " << what << ", " << left
       << " s left" << std::flush;
}

}  // namespace mbncc::cli
