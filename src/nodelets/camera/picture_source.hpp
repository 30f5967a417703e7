// SPDX-License-Identifier: BSD-3-Clause
// Where the camera nodelet's pictures come from: a device, a stream, a folder or a video file.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/camera_config.hpp"

namespace mbncc::nodelets {

/// A source as it may be told to anybody: without the user, password and query of a stream's URL,
/// and without what follows the first word of a pipeline that holds one.
std::string without_secrets(const std::string& source);

class PictureSource {
 public:
  virtual ~PictureSource() = default;

  /// Takes the next picture without decoding it, so that it can be stamped at once; a live source
  /// waits for it. False at the end. Throws FileError when the source has failed: open it again.
  virtual bool grab() = 0;

  /// The picture just grabbed, CV_8UC3 or CV_8UC1. Throws FileError when it cannot be read; the
  /// next one may be.
  virtual cv::Mat retrieve() = 0;

  /// Live sources go on whether or not anybody takes the pictures, at their own pace.
  virtual bool is_live() const = 0;

  /// [Hz] pace at which the pictures were taken; 0: unknown.
  virtual double rate() const = 0;
};

/// Opens `config.source` and asks a device for the settings. `refused` gets a sentence for each
/// setting that the device did not take. Throws FileError when the source cannot be opened now. No
/// sentence tells a stream's secrets.
std::unique_ptr<PictureSource> open_picture_source(const CameraConfig& config,
                                                   std::vector<std::string>& refused);

}  // namespace mbncc::nodelets
