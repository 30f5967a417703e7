// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/interactive_lesson.hpp"

#include <utility>

#include "learning/teaching/lesson_run.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kMostStates = 65;  // the lesson and 64 edits; each state holds full-size maps

}  // namespace

struct InteractiveLesson::Implementation {
  LearningConfig config;
  SearchConfig search;
  std::vector<teaching::LessonState> states;  // the lesson, and each edit in force
};

InteractiveLesson::InteractiveLesson(const Lesson& lesson, const LearningConfig& config,
                                     const SearchConfig& search, const StageObserver& observer)
    : implementation_(std::make_unique<Implementation>()) {
  implementation_->config = config;
  implementation_->search = search;
  teaching::LessonState state;
  state.lesson = lesson;
  teaching::run_lesson(state, config, search, observer);
  implementation_->states.push_back(std::move(state));
}

InteractiveLesson::~InteractiveLesson() = default;
InteractiveLesson::InteractiveLesson(InteractiveLesson&&) noexcept = default;
InteractiveLesson& InteractiveLesson::operator=(InteractiveLesson&&) noexcept = default;

const LearnResult& InteractiveLesson::result() const {
  return implementation_->states.back().result;
}

LearnResult InteractiveLesson::edit(const LessonEdit& edit, const StageObserver& observer) {
  teaching::LessonState state = implementation_->states.back();
  teaching::run_edit(state, edit, implementation_->config, implementation_->search, observer);
  if (!state.result.has_model) return state.result;
  auto& states = implementation_->states;
  states.push_back(std::move(state));
  if (states.size() > kMostStates) states.erase(states.begin());
  return result();
}

bool InteractiveLesson::undo() {
  if (implementation_->states.size() < 2) return false;
  implementation_->states.pop_back();
  return true;
}

}  // namespace mbncc
