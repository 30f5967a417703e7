// SPDX-License-Identifier: BSD-3-Clause
// Faint change that is not significant in single pixels, in noisy images with little light.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// Squared distances [variances] of the image before from the unchanged and from the shadowed
/// platform, CV_32FC1.
struct Misfit {
  cv::Mat unchanged, shaded;
};

/// 255 where neither the unchanged platform nor a shadow on it explains wide patches, even if no
/// single pixel is significant. `variance` (CV_32FC3) is that of a pixel of `after` (CV_32FC3),
/// `tail` is a factor on it; `sure` (CV_8UC1) marks pixels whose change is significant alone.
cv::Mat faint_change(const Misfit& misfit, const cv::Mat& after, const cv::Mat& variance,
                     float tail, const cv::Mat& sure);

}  // namespace mbncc::likelihood
