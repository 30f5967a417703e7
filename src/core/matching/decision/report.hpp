// SPDX-License-Identifier: BSD-3-Clause
// Selects what is reported of the matches in an image.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::decision {

/// The matches whose reference points lie in `roi` [px] (empty: all), symmetric ones at an
/// equivalent pose; of each name the `most` best, with which the others compete. Best score first.
std::vector<Match> reported(std::vector<Match> matches, const cv::Rect& roi, int most,
                            const SearchConfig& config);

}  // namespace mbncc::decision
