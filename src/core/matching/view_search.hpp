// From all poses of one view down to a few refined ones.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/detection.hpp"

namespace mbncc {

/// Candidates of `view` whose anchors lie in `roi` [px], refined to full resolution, best first.
/// Several may describe one place: other angles are needed to judge the margin.
std::vector<Detection> search_view(const PreparedObject& object, const PreparedView& view,
                                   const ScenePicture& scene, const cv::Rect& roi);

}  // namespace mbncc
