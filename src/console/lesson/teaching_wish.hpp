// SPDX-License-Identifier: BSD-3-Clause
// How a lesson treats an existing object.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>

#include <string>

namespace mbncc::console {

struct TeachingWish {
  enum class What { kNew, kReplace, kView };
  What what = What::kNew;
  std::string name;  ///< "": the server chooses
};

/// Adapts the goal of a lesson to that choice. A further view provides only its image; height and
/// symmetry are those of the stored object.
inline mbncc_vision::LearnObjectGoal goal_of(const TeachingWish& wish,
                                             mbncc_vision::LearnObjectGoal described) {
  using Goal = mbncc_vision::LearnObjectGoal;
  described.name = wish.name;
  described.overwrite = wish.what == TeachingWish::What::kReplace;
  described.add_view = wish.what == TeachingWish::What::kView;
  if (described.add_view) {
    described.object_height = 0;
    described.symmetry = Goal::SYMMETRY_AUTO;
  }
  return described;
}

}  // namespace mbncc::console
