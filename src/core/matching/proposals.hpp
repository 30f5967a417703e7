// What the coarse searches of one view propose.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "matching/descent.hpp"
#include "matching/places.hpp"

namespace mbncc {

/// Poses of a view, each search's best first, whose anchors lie in `roi` [px] and `places`.
class Proposals {
 public:
  Proposals(const PreparedView& view, const ScenePicture& scene, const cv::Rect& roi,
            const Places& places)
      : view_(view), scene_(scene), roi_(roi), places_(places) {}

  /// Searches by edges: at most `most` poses, and `round_places` places whose rotation the surface
  /// has to tell.
  void follow_edges(std::size_t most, std::size_t round_places);
  /// The same, and as many more as colours may choose from.
  void follow_edges_anywhere(std::size_t most, std::size_t round_places);
  /// Searches by rotated correlation within `places`, unless that would be at one of the finest
  /// levels: at most `most` places.
  void correlate(int most, const Places& places);

  /// Of those by edges the first `most`, and those at round places.
  CandidatesPerLevel by_edges(std::size_t most) const;
  CandidatesPerLevel by_correlation() const;
  /// Of all those by edges the `most` whose colours speak most for the object, too.
  CandidatesPerLevel by_colours(std::size_t most) const;

  /// Edges proposed the place of `pose` [px] among the first `count`.
  bool foremost_by_edges(const Pose2D& pose, std::size_t count) const;

 private:
  void search_edges(std::size_t foremost, std::size_t most, std::size_t round_places);
  void add_rotations_by_surface(const Candidate& place);

  const PreparedView& view_;
  const ScenePicture& scene_;
  cv::Rect roi_;
  const Places& places_;
  std::vector<Candidate> correlated_, edges_, round_;
};

}  // namespace mbncc
