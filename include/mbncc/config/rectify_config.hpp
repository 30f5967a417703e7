// SPDX-License-Identifier: BSD-3-Clause
// Settings of the rectify nodelet.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"
#include "mbncc/config/image_config.hpp"

namespace mbncc {

struct RectifyConfig {
  ImageConfig images;
  bool top_view = false;            ///< publish the view from straight above
  std::string platform_frame;       ///< tf frame whose x-y plane the top view looks down on
  std::string platform_intrinsics;  ///< camera that platform_frame was calibrated with
  std::string camera_frame;         ///< optical frame; "": the images' frame_id
  bool rectified = false;           ///< the received images are rectified: use P, else K and D
  double max_info_age = 60;         ///< [s] age after which a camera_info is no longer used

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    ImageConfig::fields(self.images, visit);
    visit(FieldInfo{"top_view", Allowed::anything(), "",
                    "publish top_view/image_rect, which shows the platform as a fixed camera would "
                    "from straight above; false: image_rect, only the lens is corrected"},
          self.top_view);
    visit(FieldInfo{"platform_frame", Allowed::frame(), "",
                    "tf frame whose x-y plane is the platform; needed for the top view"},
          self.platform_frame);
    visit(FieldInfo{"platform_intrinsics", Allowed::anything(), "",
                    "camera that platform_frame was calibrated with, as calibrate_platform writes "
                    "it; with another one there is no top view; empty: not compared"},
          self.platform_intrinsics);
    visit(FieldInfo{"camera_frame", Allowed::frame(), "",
                    "optical frame of the camera; empty: the images' frame_id"},
          self.camera_frame);
    visit(
        FieldInfo{"rectified", Allowed::anything(), "",
                  "for the top view: the received images are rectified; P of camera_info is used, "
                  "otherwise K and D"},
        self.rectified);
    visit(
        FieldInfo{"max_info_age", Allowed::at_least(0.1), "s", "an older camera_info is not used"},
        self.max_info_age);
  }
};

}  // namespace mbncc
