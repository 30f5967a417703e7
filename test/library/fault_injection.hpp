// Lets one system call of the library fail, or the process die at it. The functions of this name in
// the test program take the place of libc's, so that the library needs no seam for its tests.
#pragma once

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
