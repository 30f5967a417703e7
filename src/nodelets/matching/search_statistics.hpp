// SPDX-License-Identifier: BSD-3-Clause
// Statistics of the image stream for the diagnostics.
#pragma once

#include <diagnostic_updater/DiagnosticStatusWrapper.h>

#include <cstdint>
#include <mutex>
#include <string>

namespace mbncc::nodelets {

struct SearchStatistics {
  std::uint64_t arrived = 0;    ///< images received
  std::uint64_t overtaken = 0;  ///< replaced by newer ones before they were searched
  std::uint64_t searched = 0;
  std::uint64_t refused = 0;  ///< bad encoding or layout, or search_roi outside the image
  std::uint64_t failed = 0;   ///< searches that ended in an exception
  std::uint64_t badly_stamped = 0;
  std::string last_fault;   ///< of the last refused or badly stamped image
  double search_time = 0;   ///< [s] of the last search
  double latency = 0;       ///< [s] from the last image's stamp to its publication
  std::string message;      ///< of the last array; empty: no fault
  bool unreliable = false;  ///< the last array was STALE or SEARCH_FAILED
};

/// Summary of the diagnostics: an error if results must not be used. `fault`: why no search is
/// possible, "" if it is. `idle`: why nothing is searched, "" if searching.
inline void summarize(diagnostic_updater::DiagnosticStatusWrapper& status, const std::string& fault,
                      const std::string& idle, const SearchStatistics& statistics) {
  using diagnostic_msgs::DiagnosticStatus;
  if (!fault.empty())
    status.summary(DiagnosticStatus::ERROR, fault);
  else if (!idle.empty())
    status.summary(DiagnosticStatus::OK, "idle: " + idle);
  else if (!statistics.message.empty())
    status.summary(statistics.unreliable ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN,
                   statistics.message);
  else
    status.summary(DiagnosticStatus::OK, "searching");
}

inline void add_to(diagnostic_updater::DiagnosticStatusWrapper& status,
                   const SearchStatistics& statistics) {
  status.add("images arrived", statistics.arrived);
  status.add("images searched", statistics.searched);
  status.add("images dropped for newer ones", statistics.overtaken);
  status.add("images refused", statistics.refused);
  status.add("images with bad stamps", statistics.badly_stamped);
  status.add("searches failed", statistics.failed);
  status.add("last fault", statistics.last_fault);
  status.add("search time [s]", statistics.search_time);
  status.add("latency [s]", statistics.latency);
}

/// Thread-safe statistics.
class SharedStatistics {
 public:
  template <class Change>
  auto change(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return change(statistics_);
  }

  SearchStatistics get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return statistics_;
  }

 private:
  mutable std::mutex mutex_;
  SearchStatistics statistics_;
};

}  // namespace mbncc::nodelets
