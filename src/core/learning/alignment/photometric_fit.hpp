// SPDX-License-Identifier: BSD-3-Clause
// Exposure and light between two images of a still scene: per channel, a gain that may vary
// linearly across the image, and an offset.
#pragma once

#include <array>
#include <opencv2/core.hpp>

namespace mbncc::alignment {

/// before = after (1 + gain + gain_x u + gain_y v) + offset, with u, v in -0.5 .. 0.5 across the
/// image.
struct ChannelLight {
  double gain = 0;
  double gain_x = 0;
  double gain_y = 0;
  double offset = 0;  ///< [grey levels]
};

using Light = std::array<ChannelLight, 3>;

/// Robust fit (Tukey weights) over the pixels of `trusted` (CV_8UC1); images are CV_8UC3 or
/// CV_32FC3. Pixels that deviate by more than 15 % and 8 grey levels are left out, because they may
/// be in a shadow in one of the images.
/// Without `planar` the gain is constant. Fewer than 200 samples give the identity.
Light fit_light(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted, bool planar);

/// The given rows of `after` (CV_8UC3 or CV_32FC3), corrected to the light of `before`, CV_32FC3.
cv::Mat apply_light(const cv::Mat& after, const Light& light,
                    const cv::Range& rows = cv::Range::all());

}  // namespace mbncc::alignment
