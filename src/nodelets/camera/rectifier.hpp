// SPDX-License-Identifier: BSD-3-Clause
// Converts a camera's images to those of a camera without distortion at the same position.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/cell/top_view.hpp"
#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {

class Rectifier {
 public:
  /// Converts `image` (CV_8UC3), taken through `lens`, to an image of the camera `wanted` of the
  /// same size; black where the lens shows nothing. The first image of a lens or camera takes
  /// longer.
  cv::Mat rectify(const cv::Mat& image, const Lens& lens, const TurnedCamera& wanted);

 private:
  void prepare(const Lens& lens, const TurnedCamera& wanted, cv::Size size);

  Lens lens_;                   // lens for which the maps were computed
  TurnedCamera wanted_;         // camera for which the maps were computed
  cv::Mat places_, fractions_;  // coordinates in the raw image, for cv::remap
};

}  // namespace mbncc::nodelets
