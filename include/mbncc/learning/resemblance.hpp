// SPDX-License-Identifier: BSD-3-Clause
// A new object beside the known ones: which of them looks most like it, and where its frame lies
// when it is one of them.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Pose of the stored object's frame in `picture`, the learning picture of `view`: the object is
/// searched there, and counts as found where its outline covers the view's map. All views of an
/// object thus share one frame. None when it is not found: the views have too little in common.
std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& picture, const SearchConfig& search = {});

/// Searches the known objects, those of the same name aside, where `object` lies in its learning
/// picture, and notes the one that scores highest there. When that one would be grasped there, the
/// verdict is MARGINAL at best, for the reason "resembles_known".
void note_resemblance(ObjectModel& object, const cv::Mat& picture,
                      const std::vector<std::shared_ptr<const ObjectModel>>& known,
                      const SearchConfig& search = {});

}  // namespace mbncc
