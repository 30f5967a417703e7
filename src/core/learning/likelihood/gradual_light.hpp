// SPDX-License-Identifier: BSD-3-Clause
// Light that changes gradually: soft shadow, an object's coloured reflection on the platform,
// exposure drift, banding. Objects end in an edge; light seldom does.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::likelihood {

/// Least height, in the unit of `heights`, that a path from the image's border to each pixel must
/// cross (minimax path, as in watersheds by flooding). `heights` is CV_32FC1, 0 or more; no path
/// starts on border pixels that `closed` (CV_8UC1, may be empty) marks. Pixels without a path get
/// more than all heights.
cv::Mat barrier_from_frame(const cv::Mat& heights, const cv::Mat& closed = {});

/// CV_8UC1, 255 where the change is reached from the image's border over slopes far lower than
/// those that surround most of the change; for a shadow that leaves the platform's texture visible,
/// slopes of half their height suffice. `changed` (CV_32FC1) is the probability of change,
/// `texture_loss` as by texture_loss(), `sigma` [grey levels] is the noise of a channel's
/// difference.
cv::Mat gradual_light(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                      const cv::Mat& texture_loss, float sigma);

}  // namespace mbncc::likelihood
