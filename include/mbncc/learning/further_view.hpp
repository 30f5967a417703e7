// SPDX-License-Identifier: BSD-3-Clause
// Adds a further view to a known object.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Pose of the stored object's frame in `image`, the learning image of `view`. `image` is searched
/// for the object, which counts as found if its outline overlaps the view's map with an IoU of at
/// least 0.5, so all views of an object share one frame. None if it is not found, because the views
/// have too little in common.
std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& image, const SearchConfig& search = {});

/// Adds the view of `learned`, taught from `image`, to `stored`, in the stored object's frame and
/// at its height; the verdict is that of the newest view. Refuses and leaves `stored` unchanged if
/// the stored object is not found in the image or already has this view.
std::optional<Refusal> add_view(ObjectModel& stored, const ObjectModel& learned,
                                const cv::Mat& image, const SearchConfig& search = {});

/// If add_view() would refuse the view, the verdict becomes BAD for the reason "view_refused", with
/// the refusal's message and hint as the first advice, so that the operator reads them before
/// correcting the view. Returns the refusal.
std::optional<Refusal> note_refused_view(ObjectModel& learned, const ObjectModel& stored,
                                         const cv::Mat& image, const SearchConfig& search = {});

}  // namespace mbncc
