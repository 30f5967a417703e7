// SPDX-License-Identifier: BSD-3-Clause
// Resources of this process: memory, open files, threads.
#pragma once

#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

namespace mbncc::test {

struct ProcessState {
  double resident = 0;  ///< [MB]
  double in_use = 0;    ///< [MB] allocated and not freed; 0 with sanitizers
  int files = 0;        ///< open descriptors
  int threads = 0;
};

/// False if /proc is not mounted, as in a bare chroot; the resources are then unknown.
inline bool process_is_visible() {
  return std::filesystem::exists("/proc/self/statm");
}

/// [MB] allocated and not freed, in all of malloc's arenas.
inline double allocated() {
#if __GLIBC_PREREQ(2, 33)
  const struct mallinfo2 info = ::mallinfo2();
#else
  const struct mallinfo info = ::mallinfo();
#endif
  return static_cast<double>(info.uordblks + info.hblkhd) / 1e6;
}

inline ProcessState process_state() {
  using std::filesystem::directory_iterator;
  ProcessState state;
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages >> pages;
  state.resident = static_cast<double>(pages) * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
  state.in_use = allocated();
  state.files = static_cast<int>(std::distance(directory_iterator("/proc/self/fd"), {})) - 1;
  state.threads = static_cast<int>(std::distance(directory_iterator("/proc/self/task"), {}));
  return state;
}

/// Process states over the images of a long run; the first fifth is taken as settling time.
class StateHistory {
 public:
  /// Appends each sample to `csv` immediately, unless `csv` is "".
  explicit StateHistory(const std::string& csv = "") {
    if (csv.empty()) return;
    csv_.open(csv);
    csv_ << "frame,resident_mb,in_use_mb,files,threads" << std::endl;
  }

  void add(long frame) {
    samples_.push_back({frame, process_state()});
    const ProcessState& state = samples_.back().state;
    if (csv_.is_open())
      csv_ << frame << ',' << state.resident << ',' << state.in_use << ',' << state.files << ','
           << state.threads << std::endl;
  }

  /// [MB] resident memory in the last tenth minus that in the third tenth, each as a median.
  double growth() const { return growth_of(&ProcessState::resident); }
  /// [MB] the same for memory that is allocated and not freed.
  double growth_in_use() const { return growth_of(&ProcessState::in_use); }
  /// Minimum of open files in the last tenth minus that in the third tenth: short-lived files and
  /// connections do not count, leaked ones do.
  int new_files() const {
    return fewest(0.9, &ProcessState::files) - fewest(0.2, &ProcessState::files);
  }
  int new_threads() const {
    return fewest(0.9, &ProcessState::threads) - fewest(0.2, &ProcessState::threads);
  }

 private:
  struct Sample {
    long frame;
    ProcessState state;
  };

  std::size_t index(double part) const {
    return static_cast<std::size_t>(part * static_cast<double>(samples_.size()));
  }

  /// The samples in the tenth of the run that begins at `part`.
  std::vector<ProcessState> tenth(double part) const {
    std::vector<ProcessState> states;
    for (std::size_t i = index(part); i <= index(part + 0.1) && i < samples_.size(); ++i)
      states.push_back(samples_[i].state);
    return states;
  }

  int fewest(double part, int ProcessState::*count) const {
    int fewest = std::numeric_limits<int>::max();
    for (const ProcessState& state : tenth(part)) fewest = std::min(fewest, state.*count);
    return fewest;
  }

  double growth_of(double ProcessState::*size) const {
    return median(0.9, size) - median(0.2, size);
  }

  double median(double part, double ProcessState::*size) const {
    std::vector<double> values;
    for (const ProcessState& state : tenth(part)) values.push_back(state.*size);
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
  }

  std::vector<Sample> samples_;
  std::ofstream csv_;
};

}  // namespace mbncc::test
