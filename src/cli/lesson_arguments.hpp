// SPDX-License-Identifier: BSD-3-Clause
// Reads the options of `mbncc learn`.
#pragma once

#include <optional>
#include <vector>

#include "cli/arguments.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc::cli {

std::vector<Option> lesson_options();

/// Throws UsageError for contradictory options.
void check_lesson_arguments(const Arguments& arguments);

/// Reads the images of the lesson. Throws UsageError, FileError.
Lesson lesson_from(const Arguments& arguments);

/// The declared symmetry; none for "auto". Throws UsageError.
std::optional<int> symmetry_from(const Arguments& arguments);

/// The strokes; none if no strokes are given. Throws UsageError.
std::optional<LessonEdit> edit_from(const Arguments& arguments);

}  // namespace mbncc::cli
