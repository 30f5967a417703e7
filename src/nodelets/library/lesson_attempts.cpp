// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/library/lesson_attempts.hpp"

#include <utility>

namespace mbncc::nodelets {
namespace {

using Existing = ObjectLibrary::Existing;

bool is_same(const cv::Mat& one, const cv::Mat& other) {
  return one.size() == other.size() && one.type() == other.type() && cv::norm(one, other) == 0;
}

bool is_same(const View& one, const View& other) {
  return one.origin == other.origin && is_same(one.map, other.map) &&
         is_same(one.template_image, other.template_image);
}

}  // namespace

// The time tells the object from one that another lesson has stored under this name meanwhile.
bool LessonAttempts::has_stored(ObjectLibrary& library, const ObjectModel& model) const {
  const auto stored = library.load()->find(model.name);
  return stored && stored->learned_at == model.learned_at && stored->taught_by == model.taught_by;
}

ObjectModel LessonAttempts::save(ObjectLibrary& library, ObjectModel model, Existing existing) {
  if (learned_at_) {
    model.learned_at = *learned_at_;
    if (has_stored(library, model)) existing = Existing::kReplace;
  }
  learned_at_ = model.learned_at;
  return library.save(std::move(model), existing);
}

ObjectModel LessonAttempts::add_view(ObjectLibrary& library, const std::string& name,
                                     const std::function<void(ObjectModel&)>& add) {
  return library.edit(name, [&](ObjectModel& stored) {
    if (view_ && is_same(stored.views.back(), *view_)) stored.views.pop_back();
    add(stored);
    view_ = stored.views.back();
  });
}

}  // namespace mbncc::nodelets
