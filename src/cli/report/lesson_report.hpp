// SPDX-License-Identifier: BSD-3-Clause
// The outcome of a lesson in words and in JSON.
#pragma once

#include <ostream>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {

void write_lesson(std::ostream& out, const LearnResult& result);
void print_lesson(std::ostream& out, const LearnResult& result);

}  // namespace mbncc::cli
