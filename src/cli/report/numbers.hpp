// SPDX-License-Identifier: BSD-3-Clause
// Parses numbers in option values.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace mbncc::cli {

/// Parses "x,y,w,h" with w, h > 0. Throws UsageError that names the option.
cv::Rect parse_rectangle(const std::string& option, const std::string& text);

/// Parses "x,y". Throws UsageError that names the option.
cv::Point2f parse_point(const std::string& option, const std::string& text);

/// Parses "x,y[,x,y...]". Throws UsageError that names the option.
std::vector<cv::Point2f> parse_points(const std::string& option, const std::string& text);

/// Parses an integer of at least `lowest`. Throws UsageError that names the option.
int parse_whole(const std::string& option, const std::string& text, int lowest);

/// Parses a number in [low, high]. Throws ConfigError that names the option.
double parse_number(const std::string& option, const std::string& text, double low, double high);

/// `value`, or 0 if it would be printed as -0 with this number of decimals.
double unsigned_zero(double value, int digits);

}  // namespace mbncc::cli
