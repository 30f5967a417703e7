// SPDX-License-Identifier: BSD-3-Clause
// At most so many pictures a second, and as many as that where enough come.
#pragma once

namespace mbncc {

/// Time that passes is saved up for the next pictures, for two at most: of 30 pictures a second a
/// limit of 20 lets two in three pass, and one of 30 all, also when they come unevenly.
class RateLimit {
 public:
  /// May a picture stamped `stamp` [s] pass at `rate` [Hz]? 0: always.
  bool allows(double stamp, double rate) const;

  /// It has passed.
  void note(double stamp, double rate);

  /// The clock has jumped back.
  void reset() { *this = {}; }

 private:
  double credit(double stamp, double rate) const;

  bool any_ = false;
  double last_ = 0;   // [s] stamp of the last one that passed
  double saved_ = 0;  // pictures, after it
};

}  // namespace mbncc
