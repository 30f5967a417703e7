// SPDX-License-Identifier: BSD-3-Clause
// Places the labels of marks beside their objects without overlapping other labels or objects.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::console {

/// A label to place; all in pixels of the widget.
struct LabelledThing {
  cv::Rect box;    ///< bounding box of the object
  cv::Size label;  ///< its label's size
};

/// A position for each label, inside `room` unless that is too small, and as near to its object as
/// the other labels and objects allow.
std::vector<cv::Rect> place_labels(const std::vector<LabelledThing>& things, const cv::Rect& room);

}  // namespace mbncc::console
