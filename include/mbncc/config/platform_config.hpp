// SPDX-License-Identifier: BSD-3-Clause
// Settings of the platform's plane and of the camera.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct PlatformConfig {
  std::string platform_frame;  ///< tf frame whose x-y plane is the platform; "": use the distance
  std::string platform_intrinsics;  ///< camera that platform_frame was calibrated with
  double platform_distance = 0;     ///< [m] along the optical axis; 0: unknown
  bool rectified = true;            ///< images are rectified: P of camera_info, else K and D
  std::string camera_frame;         ///< optical frame; "": the images' frame_id
  double max_info_age = 60;         ///< [s] age after which a camera_info is no longer used

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"platform_frame", Allowed::frame(), "",
                    "tf frame whose x-y plane is the platform; empty: platform_distance"},
          self.platform_frame);
    visit(FieldInfo{"platform_intrinsics", Allowed::anything(), "",
                    "camera that platform_frame was calibrated with, as calibrate_platform writes "
                    "it; with another one there are no poses in metres; empty: not compared"},
          self.platform_intrinsics);
    visit(FieldInfo{"platform_distance", Allowed::range(0, 100), "m",
                    "distance of the platform along the optical axis; 0: unknown"},
          self.platform_distance);
    visit(FieldInfo{"rectified", Allowed::anything(), "",
                    "images are rectified: P of camera_info is used, otherwise K and D"},
          self.rectified);
    visit(FieldInfo{"camera_frame", Allowed::frame(), "",
                    "optical frame of the camera; empty: the images' frame_id"},
          self.camera_frame);
    visit(
        FieldInfo{"max_info_age", Allowed::at_least(0.1), "s", "an older camera_info is not used"},
        self.max_info_age);
  }
};

}  // namespace mbncc
