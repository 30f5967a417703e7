// SPDX-License-Identifier: BSD-3-Clause
// Compares a new object with the known ones: finds the most similar one, and the pose of its frame
// if it is the same object.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Pose of the stored object's frame in `image`, the learning image of `view`. The object is
/// searched there and counts as found if its outline covers the view's map, so all views of an
/// object share one frame. None if it is not found because the views have too little in common.
std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& image, const SearchConfig& search = {});

/// Searches the known objects (except those of the same name) at the place of `object` in its
/// learning image, and records the one with the highest score. If that one would be graspable
/// there, the verdict is MARGINAL at best, for the reason "resembles_known".
void note_resemblance(ObjectModel& object, const cv::Mat& image,
                      const std::vector<std::shared_ptr<const ObjectModel>>& known,
                      const SearchConfig& search = {});

}  // namespace mbncc
