// SPDX-License-Identifier: BSD-3-Clause
// What the operator wants a lesson to do about the library.
#pragma once

#include <mbncc_vision/LearnObjectGoal.h>

#include <string>

namespace mbncc::console {

struct TeachingWish {
  enum class What { kNew, kReplace, kView };
  What what = What::kNew;
  std::string name;  ///< "": the server chooses
};

/// The goal of a lesson as the operator described it, changed to do what he wants. A further view
/// brings nothing but its picture: height and symmetry stay the stored object's.
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
