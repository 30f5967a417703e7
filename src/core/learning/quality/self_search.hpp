// SPDX-License-Identifier: BSD-3-Clause
// Searches the new object in its learning image: whether it is found, and only there.
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::quality {

/// Fills in self_score, self_error, runner_up and search_time. `object` has one view at least.
void search_itself(const ObjectModel& object, const cv::Mat& image, const SearchConfig& search,
                   Quality& quality);

}  // namespace mbncc::quality
