// SPDX-License-Identifier: BSD-3-Clause
// Compares a new object with the known ones and finds the most similar one.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Searches the place of `object` in its learning image for the known objects (except those of the
/// same name), and records the one with the highest score. If that one would be graspable there,
/// the verdict is MARGINAL at best, for the reason "resembles_known".
void note_resemblance(ObjectModel& object, const cv::Mat& image,
                      const std::vector<std::shared_ptr<const ObjectModel>>& known,
                      const SearchConfig& search = {});

}  // namespace mbncc
