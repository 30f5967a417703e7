// Settings of the rectify nodelet.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct RectifyConfig {
  std::string image_transport = "raw";  ///< how pictures travel: raw, compressed, ...

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"image_transport", Allowed::anything(), "",
                    "how pictures travel: raw, compressed, ..."},
          self.image_transport);
  }
};

}  // namespace mbncc
