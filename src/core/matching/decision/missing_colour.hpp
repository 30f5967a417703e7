// SPDX-License-Identifier: BSD-3-Clause
// Doubts matches whose colours cannot be compared.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::decision {

/// An object taught in colour and found in a grey `image`, or taught in grey and found where there
/// is colour, was compared in grey, in which another object of the same outline may look the same.
/// A grey lesson may also be that of a grey object.
void doubt_missing_colour(const std::function<bool(const std::string& name)>& is_taught_in_colour,
                          const cv::Mat& image, bool grey, const SearchConfig& config,
                          std::vector<Match>& matches);

}  // namespace mbncc::decision
