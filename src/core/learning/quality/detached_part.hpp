// SPDX-License-Identifier: BSD-3-Clause
// Small separate parts of a map: mostly slips of the brush, which move the object's reference point
// and enlarge its circle.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

namespace mbncc::quality {

struct DetachedPart {
  int area = 0;      ///< [px]
  cv::Point centre;  ///< [px]
};

/// The small part of `map` (CV_8UC1) that lies farthest from the rest, if the small parts together
/// enlarge the map's excircle notably. Large parts belong to the object, as do parts of equal size.
std::optional<DetachedPart> detached_part(const cv::Mat& map);

}  // namespace mbncc::quality
