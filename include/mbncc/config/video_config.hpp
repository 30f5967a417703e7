// SPDX-License-Identifier: BSD-3-Clause
// Settings of the search through the pictures of one still camera.
#pragma once

#include "mbncc/config/field.hpp"

namespace mbncc {

struct VideoConfig {
  double sweep_time = 60;  ///< [s] in which every object is searched in the whole picture once,
                           ///< though nothing changes; 0: all objects in every picture
  double effort = 0.8;  ///< searches of one object in a whole picture, spent on a picture at most

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"sweep_time", Allowed::range(0, 3600), "s",
                    "where nothing changes, every object is searched this often; 0: every picture "
                    "is searched whole"},
          self.sweep_time);
    visit(
        FieldInfo{"effort", Allowed::range(0.1, 1000), "",
                  "searches of one object in a whole picture that a changed picture may cost; the "
                  "rest is put off to the next pictures"},
        self.effort);
  }
};

}  // namespace mbncc
