// SPDX-License-Identifier: BSD-3-Clause
// Searches the learning image for the new object: it must be found at its place, and nowhere else.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::quality {

/// Fills in self_score, self_error, runner_up and search_time. `object` has at least one view.
void search_itself(const ObjectModel& object, const cv::Mat& image, const SearchConfig& search,
                   Quality& quality);

}  // namespace mbncc::quality
