// SPDX-License-Identifier: BSD-3-Clause
// The search_roi parameter.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// Reads "x,y,width,height" [px]; "" is the empty rectangle: the whole picture. Throws ConfigError
/// naming the text and what is allowed.
cv::Rect parse_roi(const std::string& text);

/// The part of `roi` that lies in a picture of this size. Throws ConfigError when none does:
/// nothing would ever be found.
cv::Rect roi_in(const cv::Rect& roi, cv::Size picture);

}  // namespace mbncc::nodelets
