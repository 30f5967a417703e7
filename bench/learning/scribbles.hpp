// SPDX-License-Identifier: BSD-3-Clause
// The manual variant of GrabCut in the paper, with an operator's strokes on object and background.
// The strokes are drawn from the true map, so the result is an upper bound for an operator, not a
// method.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::bench {

/// cv::GrabCutClasses with strokes on the object's core, along its middle lines and around it;
/// background outside `region`, probable foreground elsewhere.
cv::Mat scribbled(const cv::Mat& true_map, const cv::Rect& region);

}  // namespace mbncc::bench
