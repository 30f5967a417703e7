// A further view of a stored object: same object, another light, place or angle.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Pose of the stored object's frame in `picture`, the learning picture of `view`: the object is
/// searched there, and counts as found where its outline covers the view's map. All views of an
/// object thus share one frame. None when it is not found: the views have too little in common.
std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& picture, const SearchConfig& search = {});

}  // namespace mbncc
