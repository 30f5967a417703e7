// SPDX-License-Identifier: BSD-3-Clause
// Limits the number of images per second, and reaches the limit if enough images arrive.
#pragma once

namespace mbncc {

/// A token bucket of at most 2.5 images: of 30 images a second, a limit of 20 passes two in
/// three, and a limit of 30 passes all, also if they arrive unevenly.
class RateLimit {
 public:
  /// Whether an image stamped `stamp` [s] may pass at `rate` [Hz]; 0: always.
  bool allows(double stamp, double rate) const;

  /// Records that an image stamped `stamp` [s] has passed at `rate` [Hz].
  void note(double stamp, double rate);

  /// Call this when the clock has jumped back.
  void reset() { *this = {}; }

 private:
  double credit(double stamp, double rate) const;

  bool any_ = false;
  double last_ = 0;   // [s] stamp of the last image that passed
  double saved_ = 0;  // [images] credit that was left after the last image
};

}  // namespace mbncc
