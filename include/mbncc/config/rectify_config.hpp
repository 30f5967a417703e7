// SPDX-License-Identifier: BSD-3-Clause
// Settings of the rectify nodelet.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"
#include "mbncc/config/image_config.hpp"

namespace mbncc {

struct RectifyConfig {
  ImageConfig images;
  double max_info_age = 60;  ///< [s] age after which a camera_info is no longer used

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    ImageConfig::fields(self.images, visit);
    visit(
        FieldInfo{"max_info_age", Allowed::at_least(0.1), "s", "an older camera_info is not used"},
        self.max_info_age);
  }
};

}  // namespace mbncc
