// SPDX-License-Identifier: BSD-3-Clause
// Prints explanations.
#pragma once

#include <opencv2/core.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "mbncc/matching/explanation.hpp"

namespace mbncc::cli {

/// Prints human-readable lines.
void print_explanations(std::ostream& out, const std::vector<Explanation>& explanations);

/// Prints one JSON object per explanation, each on its own line.
void write_explanations(std::ostream& out, const std::string& image, cv::Point2d place,
                        const std::vector<Explanation>& explanations);

}  // namespace mbncc::cli
