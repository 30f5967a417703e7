// SPDX-License-Identifier: BSD-3-Clause
// Lets one system call of the library fail, or the process die at it. The functions of this name in
// the test program take the place of libc's, so that the library needs no seam for its tests.
#pragma once

#include <sys/types.h>
#include <set>
#include <string>
#include <vector>

namespace mbncc::test {

struct FaultPlan {
  bool armed = false;
  int at = -1;                     ///< number of the call that goes wrong, counted from 0; -1: none
  int error = 0;                   ///< errno that it reports
  bool die = false;                ///< the process ends before the call instead
  bool short_write = false;        ///< write() takes one byte only; no error
  std::vector<std::string> calls;  ///< names of the calls made while armed

  // Unsynced changes by inode that a power cut would lose, and changes made too early.
  std::set<ino_t> unsafe_data;     ///< files with bytes that are not synced
  std::set<ino_t> unsafe_names;    ///< folders with entries that are not synced
  std::vector<std::string> hasty;  ///< names given to data that was not synced
};

FaultPlan& fault_plan();

/// Counts and disturbs calls as long as it lives.
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
