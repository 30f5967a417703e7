// SPDX-License-Identifier: BSD-3-Clause
// Shows the progress of a long command on a terminal.
#pragma once

#include <chrono>
#include <cstddef>
#include <ostream>
#include <string>

namespace mbncc::cli {

/// Rewrites one line of stderr if stderr is a terminal, starting after two seconds.
class Progress {
 public:
  enum Where { kAlways, kQuietOutput };  ///< kQuietOutput: only if stdout is not a terminal

  Progress(std::string what, std::size_t count, Where where = kAlways);
  /// `terminal`: whether `out` is a terminal.
  Progress(std::string what, std::size_t count, std::ostream& out, bool terminal, double patience);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Counts one finished item.
  void step();

  /// Shows the progress of one long item: the fraction done [0..1] and the current step.
  void show(double part, const std::string& what);

  bool on_terminal() const { return terminal_; }

 private:
  double seconds() const;
  void draw(double part, const std::string& what);

  const std::string what_;
  const std::size_t count_;
  std::ostream& out_;
  const bool terminal_;
  const double patience_;  // [s]
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  double drawn_at_ = -1;
  std::size_t done_ = 0;
};

}  // namespace mbncc::cli
