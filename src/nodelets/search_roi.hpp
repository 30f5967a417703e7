// The search_roi parameter.
#pragma once

#include <opencv2/core.hpp>
#include <string>

namespace mbncc::nodelets {

/// Reads "x,y,width,height" [px]; "" is the empty rectangle: the whole picture. Throws ConfigError
/// naming the text and what is allowed.
cv::Rect parse_roi(const std::string& text);

}  // namespace mbncc::nodelets
