// SPDX-License-Identifier: BSD-3-Clause
// One entry point per fuzz target, as libFuzzer expects it; replay.cpp calls it with the corpus.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace mbncc::fuzz {

/// Shows that a fuzzer reaches this point and that its build detects errors: writes beyond an array
/// when built with MBNCC_PLANTED_BUG.
inline void planted_bug([[maybe_unused]] std::size_t index) {
#ifdef MBNCC_PLANTED_BUG
  auto* bytes = new char[4];
  static_cast<volatile char*>(bytes)[4 + index % 4] = 1;
  delete[] bytes;
#endif
}

/// Takes values from the front of the fuzzer's bytes; returns zeros when they are used up.
class Pieces {
 public:
  Pieces(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  bool empty() const { return left_ == 0; }

  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

  std::string text(std::size_t length) {
    length = length < left_ ? length : left_;
    std::string result(reinterpret_cast<const char*>(data_), length);
    data_ += length;
    left_ -= length;
    return result;
  }

  std::string rest() { return text(left_); }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace mbncc::fuzz
