// SPDX-License-Identifier: BSD-3-Clause
// Explanations on the terminal.
#pragma once

#include <opencv2/core.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "mbncc/matching/explanation.hpp"

namespace mbncc::cli {

/// So many objects are explained, the likeliest.
constexpr std::size_t kExplained = 3;

/// Lines for people.
void print_explanations(std::ostream& out, const std::vector<Explanation>& explanations);

/// One object on a line per explanation.
void write_explanations(std::ostream& out, const std::string& picture, cv::Point2d place,
                        const std::vector<Explanation>& explanations);

}  // namespace mbncc::cli
