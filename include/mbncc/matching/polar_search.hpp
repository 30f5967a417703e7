// SPDX-License-Identifier: BSD-3-Clause
// The paper's matching phase, step by step: image pyramid, candidate centres, polar transform of
// the target's disc about each, normalized cross correlation over all cyclic shifts with the map,
// from coarse to fine (doi 10.1177/1687814017728839). Kept for comparison with the fast search.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/object_model.hpp"
#include "mbncc/polar.hpp"

namespace mbncc {

/// The template pixels that are correlated.
enum class PolarRegion {
  kMap,       ///< the pixels of the map: MB-NCC
  kIncircle,  ///< the largest disc inside the map: PP-NCC, omits object pixels
  kExcircle,  ///< the smallest disc around the map: PP-NCC, includes background pixels
};

/// A position and rotation of the view with its similarity.
struct PolarPose {
  Pose2D pose;            ///< [px],[rad] region's centre; rotation relative to the learning image
  double similarity = 0;  ///< [-1..1]
};

class PolarSearch {
 public:
  /// Throws std::invalid_argument when the region's radius exceeds 2048 px.
  explicit PolarSearch(const View& view, PolarRegion region = PolarRegion::kMap);

  /// Centre of the region's circle [px] in the view's crop, the reference point of the poses.
  cv::Point2d centre() const { return centre_; }

  /// Coarsest pyramid level used.
  int top_level() const { return static_cast<int>(templates_.size()) - 1; }

  /// Local maxima of the similarity with centres in `roi` [px], refined to full resolution, best
  /// first. `levels` is the grey pyramid (build_pyramid()) of the image searched.
  std::vector<PolarPose> find(const std::vector<cv::Mat>& levels, const cv::Rect& roi) const;

 private:
  std::vector<PolarPose> scan(const cv::Mat& grey, int level, const cv::Rect& roi) const;
  PolarPose refined(const cv::Mat& grey, int level, const PolarPose& coarse) const;
  PolarPose interpolated(const cv::Mat& grey, const PolarPose& best) const;

  cv::Point2d centre_;
  std::vector<PolarTemplate> templates_;  // per level
};

}  // namespace mbncc
