// SPDX-License-Identifier: BSD-3-Clause
// The description in an object file: an ObjectModel without its name and its pixels.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc::library {

constexpr const char* kTextKey = "mbncc";              ///< keyword of its text chunk
constexpr int kMaxViews = 64;                          ///< of one object
constexpr std::uint32_t kMaxRevision = 2'000'000'000;  ///< of any file

/// A model whose views have no pixels yet, and their rectangles in the file.
struct ObjectDescription {
  ObjectModel model;
  std::vector<cv::Rect> rectangles;  ///< [px] one per view, stacked from top to bottom
};

/// YAML text of the model; `rectangles` has one entry per view.
std::string write_description(const ObjectModel& model, const std::vector<cv::Rect>& rectangles);

/// A valid description in a newer format that this program cannot read.
class NewerFormat : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws NewerFormat if a later version may have written the text, and std::runtime_error with one
/// clear sentence if it is not what write_description() writes.
ObjectDescription read_description(const std::string& text);

}  // namespace mbncc::library
