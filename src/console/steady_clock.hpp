// SPDX-License-Identifier: BSD-3-Clause
// The clock of the console: its models and widgets take times in seconds since the console started.
#pragma once

#include <QElapsedTimer>

namespace mbncc::console {

class SteadyClock {
 public:
  SteadyClock() { timer_.start(); }
  double now() const { return static_cast<double>(timer_.elapsed()) / 1000.0; }

 private:
  QElapsedTimer timer_;
};

}  // namespace mbncc::console
