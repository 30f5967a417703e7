// SPDX-License-Identifier: BSD-3-Clause
// The search_roi parameter.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// Reads "x,y,width,height" [px]; "" is the empty rectangle: the whole image. Throws ConfigError
/// that names the text and the allowed values.
cv::Rect parse_roi(const std::string& text);

/// The part of `roi` inside an image of this size. Throws ConfigError if there is none, because
/// nothing could be found.
cv::Rect roi_in(const cv::Rect& roi, cv::Size image);

}  // namespace mbncc::nodelets
