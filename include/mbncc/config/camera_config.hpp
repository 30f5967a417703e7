// SPDX-License-Identifier: BSD-3-Clause
// Settings of the camera nodelet: the source of the images and what is published with them.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct CameraConfig {
  std::string source = "0";            ///< device index or path, stream URL, folder, or video file
  double frame_rate = 0;               ///< [Hz]; 0: the source's own, 10 for a folder
  bool loop = false;                   ///< restart a folder or video at its end
  int width = 0;                       ///< [px] requested from a device; 0: its default
  int height = 0;                      ///< [px]
  double exposure = -1;                ///< in the driver's unit; -1: unchanged
  double gain = -1;                    ///< in the driver's unit; -1: unchanged
  double white_balance = -1;           ///< [K]; -1: unchanged
  bool detect_frozen = true;           ///< reopen a device or stream that repeats one image
  std::string camera_name = "camera";  ///< name of the camera in the calibration
  std::string camera_info_url;         ///< location of the calibration; "": the manager's default
  std::string frame_id = "camera_optical_frame";  ///< frame of the images

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(FieldInfo{"source", Allowed::anything(), "",
                    "device index or path, stream URL, folder of images, or video file"},
          self.source);
    visit(
        FieldInfo{
            "frame_rate", Allowed::range(0, 1000), "Hz",
            "images per second, requested from a device; 0: the source's own, 10 for a folder"},
        self.frame_rate);
    visit(FieldInfo{"loop", Allowed::anything(), "", "restart a folder or video at its end"},
          self.loop);
    visit(FieldInfo{"width", Allowed::range(0, 16384), "px",
                    "image width requested from a device; 0: its default"},
          self.width);
    visit(FieldInfo{"height", Allowed::range(0, 16384), "px",
                    "image height requested from a device; 0: its default"},
          self.height);
    visit(FieldInfo{"exposure", Allowed::at_least(-1), "",
                    "exposure of a device in its driver's unit; -1: unchanged"},
          self.exposure);
    visit(FieldInfo{"gain", Allowed::at_least(-1), "",
                    "gain of a device in its driver's unit; -1: unchanged"},
          self.gain);
    visit(FieldInfo{"white_balance", Allowed::range(-1, 20000), "K",
                    "white balance of a device; -1: unchanged"},
          self.white_balance);
    visit(
        FieldInfo{
            "detect_frozen", Allowed::anything(), "",
            "reopen a device or stream that repeats one image exactly, and do not publish it"},
        self.detect_frozen);
    visit(FieldInfo{"camera_name", Allowed::anything(), "",
                    "name in the calibration: letters, digits, underscores"},
          self.camera_name);
    visit(
        FieldInfo{"camera_info_url", Allowed::anything(), "",
                  "where the calibration is stored; empty: ~/.ros/camera_info/<camera_name>.yaml"},
        self.camera_info_url);
    visit(FieldInfo{"frame_id", Allowed::frame(), "", "optical frame of the images"},
          self.frame_id);
  }
};

}  // namespace mbncc
