// SPDX-License-Identifier: BSD-3-Clause
// Makes one system call of the library fail, or ends the process at it. The functions of these
// names in the test program replace those of libc, so the library needs no hooks for its tests.
#pragma once

#include <sys/types.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

namespace mbncc::test {

struct FaultPlan {
  bool armed = false;
  int at = -1;                      ///< index of the call that fails, from 0; -1: none
  int error = 0;                    ///< errno that it reports
  bool die = false;                 ///< the process ends before the call instead
  bool short_write = false;         ///< write() writes only one byte, without an error
  std::function<void()> meanwhile;  ///< what another program does before that call
  std::vector<std::string> calls;   ///< names of the calls made while armed

  // Unsynced changes by inode that would be lost in a power failure, and names given too early.
  std::set<ino_t> unsafe_data;     ///< files with bytes that are not synced
  std::set<ino_t> unsafe_names;    ///< folders with entries that are not synced
  std::vector<std::string> hasty;  ///< names given to data that was not synced
};

FaultPlan& fault_plan();

/// Counts and disturbs calls during its lifetime.
class ArmedFault {
 public:
  explicit ArmedFault(FaultPlan plan) {
    fault_plan() = plan;
    fault_plan().armed = true;
  }
  ~ArmedFault() { fault_plan().armed = false; }
  ArmedFault(const ArmedFault&) = delete;
  ArmedFault& operator=(const ArmedFault&) = delete;
};

}  // namespace mbncc::test
