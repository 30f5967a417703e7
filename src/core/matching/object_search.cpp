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

/// Where the best of what was found lies, and a little about it; empty when nothing is likely.
cv::Rect place_of_best(const std::vector<Detection>& found) {
  const auto best = std::max_element(
      found.begin(), found.end(),
      [](const Detection& a, const Detection& b) { return a.log_odds < b.log_odds; });
  if (best == found.end() || best->log_odds < kFound) return {};
  const Pose2D pose = compose(best->pose, best->view->reference_in_anchor);
  const int reach = std::max(4, cvRound(0.25 * best->view->shape.radius()));
  return {cvRound(pose.x) - reach, cvRound(pose.y) - reach, 2 * reach + 1, 2 * reach + 1};
}

/// One look at the picture, a quick one more where the object was found: the sparing look may have
/// passed over the right angle there, or a rival of it.
std::vector<Detection> search_sparingly(const PreparedObject& object, const ScenePicture& scene,
                                        const cv::Rect& roi, Look look) {
  auto found = search_views(object, scene, roi, look);
  const cv::Rect place =
      place_of_best(found) & (roi.empty() ? cv::Rect({0, 0}, scene.size()) : roi);
  if (place.empty()) return found;
  const auto again = search_views(object, scene, place, Look::kQuick);
  found.insert(found.end(), again.begin(), again.end());
  return compare_rotations(std::move(found));
}

}  // namespace

// An instance fits one of several views best: a thorough look is worth it only when none finds it.
std::vector<Detection> search_object(const PreparedObject& object, const ScenePicture& scene,
                                     const cv::Rect& roi, Look look) {
  if (is_sparing(look)) return search_sparingly(object, scene, roi, look);
  if (object.views.size() == 1) return search_views(object, scene, roi, look);
  const auto found = search_views(object, scene, roi, Look::kQuick);
  const bool enough = std::any_of(found.begin(), found.end(), [](const Detection& detection) {
    return detection.log_odds >= kFound;
  });
  return enough ? found : search_views(object, scene, roi, look);
}

}  // namespace mbncc
