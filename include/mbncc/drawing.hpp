// SPDX-License-Identifier: BSD-3-Clause
// Draws annotations into images: outlines, object axes, captions.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Meaning of a colour.
enum class Confidence { kGood, kDoubtful, kBad, kUnsure };

/// bgr: blue, orange, vermilion, grey from the colour-blind safe palette of Okabe and Ito.
cv::Scalar colour_of(Confidence confidence);

/// One annotation in an image.
struct Marking {
  std::vector<std::vector<cv::Point2f>> outlines;  ///< [px] in the image
  Pose2D pose;  ///< [px],[rad] its axes: x vermilion arrow, y green
  cv::Scalar colour =
      colour_of(Confidence::kGood);  ///< bgr of outlines and of the caption's background
  std::string caption;               ///< plain ASCII, lines separated by \n
};

/// CV_8UC3 copy of `image` (CV_8UC3 or CV_8UC1) with the annotations, legible at a third of its
/// size.
cv::Mat draw_markings(const cv::Mat& image, const std::vector<Marking>& markings);

/// Outline and axes of a learned view in its learning image, in the colour of the verdict.
Marking marking_of(const View& view, const Quality& quality, const std::string& caption);

}  // namespace mbncc
