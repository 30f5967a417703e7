// SPDX-License-Identifier: BSD-3-Clause
// Image sources of the camera nodelet: a device, a stream, a folder or a video file.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/camera_config.hpp"

namespace mbncc::nodelets {

/// Removes the secrets from a source: the user, password and query of a stream's URL, and all text
/// after the first word of a pipeline or of a URL with spaces.
std::string without_secrets(const std::string& source);

class ImageSource {
 public:
  virtual ~ImageSource() = default;

  /// Grabs the next image without decoding it, so that it can be stamped at once; blocks on a
  /// live source. False at the end. Throws FileError if the source has failed and must be reopened.
  virtual bool grab() = 0;

  /// Decodes the grabbed image, CV_8UC3 or CV_8UC1. Throws FileError if it cannot be read; the next
  /// one may be readable.
  virtual cv::Mat retrieve() = 0;

  /// Whether the source delivers images at its own pace, whether or not they are grabbed.
  virtual bool is_live() const = 0;

  /// [Hz] rate of the recording; 0: unknown.
  virtual double rate() const = 0;
};

/// Opens `config.source` and applies the settings to a device. `refused` gets a message for each
/// setting that the device did not accept. Throws FileError if the source cannot be opened. No
/// message contains a stream's secrets.
std::unique_ptr<ImageSource> open_image_source(const CameraConfig& config,
                                               std::vector<std::string>& refused);

}  // namespace mbncc::nodelets
