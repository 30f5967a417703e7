// SPDX-License-Identifier: BSD-3-Clause
// The outcome of a lesson in words and in JSON.
#pragma once

#include <ostream>
#include <string>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {

/// `file`: where the object was stored; "": it was not.
void write_lesson(std::ostream& out, const LearnResult& result, const std::string& file);
/// Of a lesson that was stored in `file`.
void print_lesson(std::ostream& out, const LearnResult& result, const std::string& file);

}  // namespace mbncc::cli
