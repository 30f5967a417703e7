// SPDX-License-Identifier: BSD-3-Clause
// One lesson: computes an object model and its verdict from images and a region (the paper's
// learning phase).
#pragma once

#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/lesson.hpp"

namespace mbncc {

/// Segments the object and computes its verdict. A verdict BAD returns the error of its worst
/// reason with `has_model` set; the caller decides whether to store the object. This function
/// stores nothing.
LearnResult learn_object(const Lesson& lesson, const LearningConfig& config = {},
                         const SearchConfig& search = {}, const StageObserver& observer = {});

}  // namespace mbncc
