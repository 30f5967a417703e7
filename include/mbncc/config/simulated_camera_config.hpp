// SPDX-License-Identifier: BSD-3-Clause
// Settings of the simulated camera nodelet: the simulated cell and its camera.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct SimulatedCameraConfig {
  int width = 640;                 ///< [px] of the image
  int height = 480;                ///< [px]
  int seed = 1;                    ///< seed of platform, neighbours, places and noise
  int object_seed = 1;             ///< seed of the object's outline and surface
  double object_diameter = 90;     ///< [px]
  double object_elongation = 1.6;  ///< ratio of the longest to the shortest extent
  int neighbours = 2;              ///< number of other objects, which lie still
  double noise_sigma = 2;          ///< [grey levels]
  double light_gradient = 0.1;     ///< [0..1] fall-off of the light across the image
  double gain = 1;                 ///< exposure
  double frame_rate = 10;          ///< [Hz]
  bool auto_play = true;  ///< the arm moves automatically; otherwise only when a service is called
  double rest_time = 6;   ///< [s] between two motions, with auto_play
  double leg_time = 1.5;  ///< [s] of one leg of a motion: reach, carry, retreat
  std::string object_name = "object";             ///< name of the object in ~truth
  std::string frame_id = "camera_optical_frame";  ///< of images and truth
  double focal_length = 600;                      ///< [px]; 0: publish no calibration
  double distortion = 0;                          ///< k1 of the lens
  double tilt = 0;                                ///< [degrees] about x from straight down
  double principal_x = 0;          ///< [px] offset of the principal point from the image's centre
  double principal_y = 0;          ///< [px]
  double platform_distance = 0.6;  ///< [m] used for the truth in metres
  double object_height = 0;        ///< [m] of the object's top face, for the truth in metres

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"width", Allowed::range(64, 8192), "px", "width of the image"}, self.width);
    visit(FieldInfo{"height", Allowed::range(64, 8192), "px", "height of the image"}, self.height);
    visit(FieldInfo{"seed", Allowed::at_least(0), "",
                    "seed of platform, neighbours, places and noise"},
          self.seed);
    visit(FieldInfo{"object_seed", Allowed::at_least(0), "",
                    "seed of outline and surface of the moved object"},
          self.object_seed);
    visit(FieldInfo{"object_diameter", Allowed::range(16, 2000), "px",
                    "diameter of the moved object"},
          self.object_diameter);
    visit(FieldInfo{"object_elongation", Allowed::range(1, 6), "",
                    "approximate ratio of the object's longest to its shortest extent"},
          self.object_elongation);
    visit(FieldInfo{"neighbours", Allowed::range(0, 20), "", "other objects that lie still"},
          self.neighbours);
    visit(FieldInfo{"noise_sigma", Allowed::range(0, 50), "grey levels",
                    "sensor noise at medium brightness"},
          self.noise_sigma);
    visit(FieldInfo{"light_gradient", Allowed::range(0, 1), "",
                    "fall-off of the light across the image"},
          self.light_gradient);
    visit(FieldInfo{"gain", Allowed::range(0.05, 4), "", "exposure"}, self.gain);
    visit(FieldInfo{"frame_rate", Allowed::range(0.1, 120), "Hz", "images per second"},
          self.frame_rate);
    visit(
        FieldInfo{
            "auto_play", Allowed::anything(), "",
            "the arm moves automatically; false: only when ~take_away or ~put_next is called"},
        self.auto_play);
    visit(FieldInfo{"rest_time", Allowed::range(0.1, 3600), "s",
                    "time at rest between two motions, with auto_play"},
          self.rest_time);
    visit(FieldInfo{"leg_time", Allowed::range(0.1, 60), "s",
                    "duration of one leg of a motion: reach, carry, retreat"},
          self.leg_time);
    visit(FieldInfo{"object_name", Allowed::anything(), "", "name of the object in ~truth"},
          self.object_name);
    visit(FieldInfo{"frame_id", Allowed::frame(), "", "optical frame of images and truth"},
          self.frame_id);
    visit(FieldInfo{"focal_length", Allowed::range(0, 100000), "px",
                    "focal length in camera_info; 0: publish no calibration"},
          self.focal_length);
    visit(FieldInfo{"distortion", Allowed::range(-1, 1), "",
                    "radial distortion k1 of the lens; below 0: barrel"},
          self.distortion);
    visit(FieldInfo{"tilt", Allowed::range(-45, 45), "degrees",
                    "from straight down, about the camera's x axis; above 0: it looks towards the "
                    "image's upper edge"},
          self.tilt);
    visit(FieldInfo{"principal_x", Allowed::range(-8192, 8192), "px",
                    "offset of the principal point from the image centre"},
          self.principal_x);
    visit(FieldInfo{"principal_y", Allowed::range(-8192, 8192), "px",
                    "offset of the principal point from the image centre"},
          self.principal_y);
    visit(FieldInfo{"platform_distance", Allowed::range(0.01, 100), "m",
                    "distance of the platform, for the truth in metres"},
          self.platform_distance);
    visit(FieldInfo{"object_height", Allowed::range(0, 10), "m",
                    "height of the object's top face, for the truth in metres"},
          self.object_height);
  }
};

}  // namespace mbncc
