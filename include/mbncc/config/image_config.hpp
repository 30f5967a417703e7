// SPDX-License-Identifier: BSD-3-Clause
// Settings for how a nodelet receives its images.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct ImageConfig {
  std::string image_transport = "raw";  ///< transport of the images: raw, compressed, ...
  int white_level = 0;  ///< white value of 16-bit images; 0: 65535, and 16UC1 is refused

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"image_transport", Allowed::anything(), "",
                    "transport of the images: raw, compressed, ..."},
          self.image_transport);
    visit(FieldInfo{"white_level", Allowed::range(0, 65535), "",
                    "white value of 16-bit images, such as 4095 for a camera with 12 bits; 0: "
                    "65535, and 16UC1 is refused"},
          self.white_level);
  }
};

}  // namespace mbncc
