// From all poses of one view down to a few refined ones.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/candidate.hpp"
#include "matching/prepared_object.hpp"
#include "matching/scene_picture.hpp"

namespace mbncc {

/// A refined pose at full resolution with what speaks for it.
struct Detection {
  const PreparedObject* object = nullptr;
  const PreparedView* view = nullptr;
  Pose2D pose;             ///< of the anchor [px]
  cv::Matx33d covariance;  ///< of pose
  double log_odds = 0;     ///< that the object lies here
  double similarity = 0;   ///< [-1..1]
  double visible = 1;      ///< [0..1]

  double score() const;  ///< [0..1]
};

/// Candidates of `view` whose anchors lie in `roi` [px], refined to full resolution, best first.
/// Several may describe one place: other angles are needed to judge the margin.
std::vector<Detection> search_view(const PreparedObject& object, const PreparedView& view,
                                   const ScenePicture& scene, const cv::Rect& roi);

}  // namespace mbncc
