// SPDX-License-Identifier: BSD-3-Clause
// Runs the steps of a lesson, and of an edit of it.
#pragma once

#include <optional>

#include "learning/teaching/lesson_progress.hpp"
#include "learning/teaching/marks.hpp"
#include "learning/teaching/put_aside.hpp"
#include "learning/teaching/segmenter.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/lesson.hpp"
#include "mbncc/learning/lesson_edit.hpp"

namespace mbncc::teaching {

/// State of a lesson. Copies share images, which are never modified.
struct LessonState {
  Lesson lesson;
  Marks marks;
  cv::Mat changed;                    ///< as in SegmentationTask; empty without a survey
  std::optional<Segmentation> cut;    ///< without marks; none before the first cut
  std::optional<NewPlace> new_place;  ///< of an object put aside within the view
  LearnResult result;
};

/// Learns from state.lesson; fills in the rest of it. Never throws LessonEnded; `state.result`
/// contains the outcome.
void run_lesson(LessonState& state, const LearningConfig& config, const SearchConfig& search,
                const StageObserver& observer);

/// Applies `edit` to a state that has a model and evaluates it again, in the same way.
void run_edit(LessonState& state, const LessonEdit& edit, const LearningConfig& config,
              const SearchConfig& search, const StageObserver& observer);

}  // namespace mbncc::teaching
