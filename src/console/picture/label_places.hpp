// SPDX-License-Identifier: BSD-3-Clause
// Where the labels of marks go: beside what they name, over no other label and no neighbour.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::console {

/// A label to place; all in pixels of the widget.
struct LabelledThing {
  cv::Rect box;    ///< about the thing
  cv::Size label;  ///< its label's size
};

/// A place for each label inside `room`, which they leave only where it is too small for them. Each
/// is as near to its thing as the others allow.
std::vector<cv::Rect> place_labels(const std::vector<LabelledThing>& things, const cv::Rect& room);

}  // namespace mbncc::console
