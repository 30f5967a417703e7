// SPDX-License-Identifier: BSD-3-Clause
// Shows what a camera sees as another one without distortion would, that stands at the same place.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/cell/top_view.hpp"
#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {

class Rectifier {
 public:
  /// The image, CV_8UC3, of a camera with this lens, as `wanted` shows it in the same size; black
  /// where the lens shows nothing. The first image of a lens or camera takes longer.
  cv::Mat rectify(const cv::Mat& image, const Lens& lens, const TurnedCamera& wanted);

 private:
  void prepare(const Lens& lens, const TurnedCamera& wanted, cv::Size size);

  Lens lens_;                   // of the maps
  TurnedCamera wanted_;         // likewise
  cv::Mat places_, fractions_;  // coordinates in the raw image, for cv::remap
};

}  // namespace mbncc::nodelets
