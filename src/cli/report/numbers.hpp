// SPDX-License-Identifier: BSD-3-Clause
// Numbers in option values.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace mbncc::cli {

/// "x,y,w,h" with w, h > 0. Throws UsageError naming the option.
cv::Rect parse_rectangle(const std::string& option, const std::string& text);

/// "x,y". Throws UsageError naming the option.
cv::Point2f parse_point(const std::string& option, const std::string& text);

/// "x,y[,x,y...]". Throws UsageError naming the option.
std::vector<cv::Point2f> parse_points(const std::string& option, const std::string& text);

/// A whole number of at least `lowest`. Throws UsageError naming the option.
int parse_whole(const std::string& option, const std::string& text, int lowest);

/// A number in [low, high]. Throws ConfigError naming the option.
double parse_number(const std::string& option, const std::string& text, double low, double high);

/// `value`, but 0 where so many digits after the point would show -0.
double unsigned_zero(double value, int digits);

}  // namespace mbncc::cli
