// SPDX-License-Identifier: BSD-3-Clause
// Prints the outcome of a lesson as text and as JSON.
#pragma once

#include <ostream>
#include <string>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {

/// `file`: where the object was stored; "" if it was not stored.
void write_lesson(std::ostream& out, const LearnResult& result, const std::string& file);
/// Prints a lesson that was stored in `file`.
void print_lesson(std::ostream& out, const LearnResult& result, const std::string& file);

}  // namespace mbncc::cli
