// SPDX-License-Identifier: BSD-3-Clause
// Explanations on the terminal.
#pragma once

#include <opencv2/core.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "mbncc/matching/explanation.hpp"

namespace mbncc::cli {

/// Number of explained objects, the likeliest first.
constexpr std::size_t kExplained = 3;

/// Lines for people.
void print_explanations(std::ostream& out, const std::vector<Explanation>& explanations);

/// One JSON object per explanation and line.
void write_explanations(std::ostream& out, const std::string& image, cv::Point2d place,
                        const std::vector<Explanation>& explanations);

}  // namespace mbncc::cli
