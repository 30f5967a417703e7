// SPDX-License-Identifier: BSD-3-Clause
// Proposals of the coarse searches of one view.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/prepared/prepared_object.hpp"
#include "matching/proposal/search_mask.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::search {

/// Poses of a view, best first, whose anchors lie in `roi` [px] and `places`.
class Proposals {
 public:
  Proposals(const prepared::PreparedView& view, const scene::SceneImage& scene, const cv::Rect& roi,
            proposal::SearchMask places)
      : view_(view), scene_(scene), roi_(roi), places_(std::move(places)) {}

  bool everywhere() const { return places_.everywhere(); }

  /// At most `most` poses by the contour; required before foremost_by_contour().
  const std::vector<templates::Candidate>& by_contour(std::size_t most);
  /// The best `most` places by rotated correlation; none if the object needs one of the finest
  /// levels. Searches everywhere.
  std::vector<templates::Candidate> by_correlation(std::size_t most) const;

  /// Searches by the best three quarters of the contour, because the fourth may be covered, and
  /// ranks the poses by colours; required before next_by_partial_contour().
  void search_partial_contours();
  /// The next `most` of these poses, best first, that are at least `near` [px at full resolution]
  /// from all places of `known`. Each pose is returned once.
  std::vector<templates::Candidate> next_by_partial_contour(
      std::size_t most, const std::vector<templates::Candidate>& known, double near);

  /// Whether the place of `pose` [px] is among the first `count` contour proposals.
  bool foremost_by_contour(const Pose2D& pose, std::size_t count) const;

 private:
  const prepared::PreparedView& view_;
  const scene::SceneImage& scene_;
  cv::Rect roi_;
  proposal::SearchMask places_;
  std::vector<templates::Candidate> by_contour_, partial_;
  std::size_t next_ = 0;  // of partial_
};

}  // namespace mbncc::search
