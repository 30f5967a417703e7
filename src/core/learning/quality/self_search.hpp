// SPDX-License-Identifier: BSD-3-Clause
// The new object searched in the picture it was learned from: will it be found, and only there?
#pragma once

#include <opencv2/core.hpp>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Fills in self_score, self_error, runner_up and search_time. `object` has one view at least.
void search_itself(const ObjectModel& object, const cv::Mat& picture, const SearchConfig& search,
                   Quality& quality);

}  // namespace mbncc
