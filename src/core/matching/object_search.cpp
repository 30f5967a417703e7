#include "matching/object_search.hpp"

#include <algorithm>
#include <cmath>

#include "matching/effort.hpp"
#include "matching/prepared_object.hpp"

namespace mbncc {
namespace {

/// Where the anchor of a view can be when its reference point lies in `roi`.
cv::Rect anchor_region(const cv::Rect& roi, const PreparedView& view, cv::Size size) {
  const cv::Rect picture({0, 0}, size);
  if (roi.empty()) return picture;
  const int lever = static_cast<int>(std::ceil(cv::norm(view.reference_in_anchor.position())));
  return cv::Rect(roi.x - lever, roi.y - lever, roi.width + 2 * lever, roi.height + 2 * lever) &
         picture;
}

bool reference_within(const Detection& detection, const cv::Rect& roi) {
  if (roi.empty()) return true;
  const Pose2D pose = compose(detection.pose, detection.view->reference_in_anchor);
  return pose.x >= roi.x && pose.y >= roi.y && pose.x <= roi.br().x - 1 && pose.y <= roi.br().y - 1;
}

std::vector<Detection> search_views(const PreparedObject& object, const ScenePicture& scene,
                                    const cv::Rect& roi, Look look) {
  const bool gated = look == Look::kGated;
  std::vector<Detection> found;
  for (const auto& view : object.views) {
    const auto detections = search_view(object, view, scene, anchor_region(roi, view, scene.size()),
                                        look, gated ? view.gate.places(scene.classes()) : Places{});
    std::copy_if(detections.begin(), detections.end(), std::back_inserter(found),
                 [&](const Detection& detection) { return reference_within(detection, roi); });
  }
  return object.views.size() > 1 ? compare_rotations(std::move(found)) : found;
}

}  // namespace

// An instance fits one of several views best: a thorough look is worth it only when none finds it.
std::vector<Detection> search_object(const PreparedObject& object, const ScenePicture& scene,
                                     const cv::Rect& roi, Look look) {
  if (is_sparing(look) || object.views.size() == 1) return search_views(object, scene, roi, look);
  const auto found = search_views(object, scene, roi, Look::kQuick);
  const bool enough = std::any_of(found.begin(), found.end(), [](const Detection& detection) {
    return detection.log_odds >= kFound;
  });
  return enough ? found : search_views(object, scene, roi, look);
}

}  // namespace mbncc
