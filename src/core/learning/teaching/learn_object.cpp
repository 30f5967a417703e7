// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/learn_object.hpp"

#include "mbncc/learning/interactive_lesson.hpp"

namespace mbncc {

LearnResult learn_object(const Lesson& lesson, const LearningConfig& config,
                         const SearchConfig& search, const StageObserver& observer) {
  return InteractiveLesson(lesson, config, search, observer).result();
}

}  // namespace mbncc
