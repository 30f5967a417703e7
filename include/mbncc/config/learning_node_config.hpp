// SPDX-License-Identifier: BSD-3-Clause
// Settings of the learning nodelet.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"
#include "mbncc/config/image_config.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/config/platform_config.hpp"

namespace mbncc {

struct LearningNodeConfig {
  LearningConfig learning;
  PlatformConfig platform;
  ImageConfig images;
  std::string library_path = "~/.ros/mbncc_library";  ///< folder of the learned objects
  double learn_timeout = 120;  ///< [s] for a lesson whose goal does not set it
  double still_time = 0.5;     ///< [s] without motion after which a scene is still
  int max_objects = 1000;      ///< largest number of objects in the library
  std::string cell_name;       ///< stored with each taught object; "": host name and namespace
  std::string gripper_frame;   ///< tf frame that mark_grasp records; "": refused

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"library_path", Allowed::anything(), "",
                    "folder of the learned objects; ~ is the home folder"},
          self.library_path);
    LearningConfig::fields(self.learning, visit);
    visit(
        FieldInfo{
            "learn_timeout", Allowed::range(0.1, 86400), "s",
            "time limit of a lesson whose goal sets none; it stops when the operator is asked"},
        self.learn_timeout);
    visit(FieldInfo{"still_time", Allowed::range(0.05, 60), "s",
                    "time without motion after which the scene counts as still"},
          self.still_time);
    visit(FieldInfo{"max_objects", Allowed::range(1, 100000), "",
                    "largest number of objects in the library"},
          self.max_objects);
    visit(FieldInfo{"cell_name", Allowed::frame(), "",
                    "name of this cell, stored as taught_by with each object that it teaches; "
                    "empty: the host name and the namespace"},
          self.cell_name);
    visit(FieldInfo{"gripper_frame", Allowed::frame(), "",
                    "tf frame of the gripper that mark_grasp records; empty: mark_grasp refuses"},
          self.gripper_frame);
    PlatformConfig::fields(self.platform, visit);
    ImageConfig::fields(self.images, visit);
  }
};

}  // namespace mbncc
