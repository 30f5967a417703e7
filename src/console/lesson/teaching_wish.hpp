// SPDX-License-Identifier: BSD-3-Clause
// How a lesson treats an existing object.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>
#include <mbncc_vision/LearnedObject.h>

#include <string>

namespace mbncc::console {

struct TeachingWish {
  enum class What { kNew, kReplace, kView };
  What what = What::kNew;
  std::string name;  ///< "": the server chooses
};

/// Adapts the goal of a lesson to that choice; `stored` is the object of that name, or null. A
/// further view provides only its image; height and symmetry are those of the stored object. An
/// object that replaces another has its label, and its height and symmetry unless `described`
/// gives others.
inline mbncc_vision::LearnObjectGoal goal_of(const TeachingWish& wish,
                                             mbncc_vision::LearnObjectGoal described,
                                             const mbncc_vision::LearnedObject* stored) {
  using Goal = mbncc_vision::LearnObjectGoal;
  described.name = wish.name;
  described.overwrite = wish.what == TeachingWish::What::kReplace;
  described.add_view = wish.what == TeachingWish::What::kView;
  if (described.add_view) {
    described.object_height = 0;
    described.symmetry = Goal::SYMMETRY_AUTO;
  }
  if (described.overwrite && stored != nullptr) {
    described.label = stored->label;
    if (described.object_height <= 0) described.object_height = stored->object_height;
    if (described.symmetry == Goal::SYMMETRY_AUTO) described.symmetry = stored->symmetry;
  }
  return described;
}

/// A sentence about what the object loses if it is replaced, after a space; "": nothing.
inline std::string loss_of(const mbncc_vision::LearnedObject& stored) {
  const bool has_threshold = stored.min_score > 0;
  if (!stored.has_grasp && !has_threshold) return "";
  return std::string(" Replacing it discards its ") + (stored.has_grasp ? "grasp" : "") +
         (stored.has_grasp && has_threshold ? " and its " : "") +
         (has_threshold ? "own min_score" : "") + ".";
}

}  // namespace mbncc::console
