// SPDX-License-Identifier: BSD-3-Clause
// Adds a further view to a known object.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "mbncc/config/search_config.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "mbncc/matching/match.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// The match of the stored object in `image`, the learning image of `view`, whose outline overlaps
/// the view's map most, with an IoU of at least 0.5; its pose is that of the object's frame. None
/// if it is not found, because the views have too little in common.
std::optional<Match> match_in_view(const ObjectModel& stored, const View& view,
                                   const cv::Mat& image, const SearchConfig& search = {});

/// Adds the view of `learned`, taught from `image`, to `stored`, in the stored object's frame and
/// at its height; the verdict is that of the newest view, but at best MARGINAL ("view_uncertain")
/// if the stored object is not graspable in the image. Refuses and leaves `stored` unchanged if the
/// stored object is not found in the image, or at two angles, or already has this view.
std::optional<Refusal> add_view(ObjectModel& stored, const ObjectModel& learned,
                                const cv::Mat& image, const SearchConfig& search = {});

/// Gives `learned` the verdict that add_view() would, so that the operator reads it before
/// correcting the view: BAD for the reason "view_refused", with the refusal's message and hint as
/// the first advice, if it would refuse. Returns the refusal.
std::optional<Refusal> try_view(ObjectModel& learned, const ObjectModel& stored,
                                const cv::Mat& image, const SearchConfig& search = {});

}  // namespace mbncc
