// SPDX-License-Identifier: BSD-3-Clause
// Light that changes gradually: soft shadow, an object's coloured reflection on the platform,
// exposure drift, banding. Objects end in an edge; light seldom does.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// [grey levels / px] Slope of `before` minus `after` in the light of `before`: root of the squares
/// summed over the channels. Both CV_32FC3 of one size; CV_32FC1.
cv::Mat light_slope(const cv::Mat& before, const cv::Mat& after);

/// [as `heights`] The least height that a path from the frame to each pixel must cross (minimax
/// path, as in watersheds by flooding). `heights` is CV_32FC1, 0 or more; no path starts on the
/// frame's pixels that `closed` (CV_8UC1, may be empty) marks. More than all heights where no path
/// leads.
cv::Mat barrier_from_frame(const cv::Mat& heights, const cv::Mat& closed = {});

/// CV_8UC1, 255 where the change is reached from the frame over slopes far lower than those that
/// surround most of the change; half as low are enough for a shadow that leaves the platform's
/// texture visible. `changed` (CV_32FC1) is the probability of change, `texture_loss` as by
/// texture_loss(), `sigma` [grey levels] the noise of a channel's difference.
cv::Mat gradual_light(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const cv::Mat& texture_loss, float sigma);

}  // namespace mbncc::likelihood
