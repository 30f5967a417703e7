// SPDX-License-Identifier: BSD-3-Clause
// The paper's manual variant of GrabCut: an operator's strokes on object and background. The
// strokes are drawn from the true map, so this is the best an operator could do, not a method.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::bench {

/// cv::GrabCutClasses: strokes on the object's core and along its middle lines, and around it,
/// background outside of `region`, probable foreground in the rest.
cv::Mat scribbled(const cv::Mat& true_map, const cv::Rect& region);

}  // namespace mbncc::bench
