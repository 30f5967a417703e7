// SPDX-License-Identifier: BSD-3-Clause
// Settings of the rectify nodelet.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"
#include "mbncc/config/picture_config.hpp"

namespace mbncc {

struct RectifyConfig {
  PictureConfig pictures;
  double max_info_age = 60;  ///< [s] since a camera_info came, after which it no longer counts

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    PictureConfig::fields(self.pictures, visit);
    visit(FieldInfo{"max_info_age", Allowed::at_least(0.1), "s",
                    "a camera_info that came longer ago does not count any more"},
          self.max_info_age);
  }
};

}  // namespace mbncc
