// SPDX-License-Identifier: BSD-3-Clause
// Settings of the search in the images of one camera that does not move.
#pragma once

#include "mbncc/config/field.hpp"

namespace mbncc {

struct VideoConfig {
  double sweep_time = 60;  ///< [s] period in which every object is searched once in the whole image
                           ///< even if nothing changes; 0: all objects in every image
  double max_search_cost = 3;  ///< of a changed image, in searches of one object in a whole image

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"sweep_time", Allowed::range(0, 3600), "s",
                    "without change, period in which every object is searched once; 0: every "
                    "image is searched completely"},
          self.sweep_time);
    visit(FieldInfo{"max_search_cost", Allowed::range(0.1, 1000), "",
                    "largest cost of a changed image, in searches of one object in a whole "
                    "image; the rest is postponed to the next images"},
          self.max_search_cost);
  }
};

}  // namespace mbncc
