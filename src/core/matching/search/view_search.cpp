// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/view_search.hpp"

#include <algorithm>

#include "matching/decision/clutter.hpp"
#include "matching/decision/clutter_penalty.hpp"
#include "matching/decision/margins.hpp"
#include "matching/search/pose_hypothesis.hpp"
#include "matching/search/proposals.hpp"
#include "matching/search/pyramid_tracking.hpp"
#include "matching/search/rotations.hpp"
#include "matching/search/search_budget.hpp"
#include "matching/search/verification.hpp"

namespace mbncc::search {
namespace {

constexpr std::size_t kFinal = 3;   // best places whose other angles are tried, ...
constexpr double kLikely = 0;       // ... and all others with at least these log-odds
constexpr double kSamePose = 1e-6;  // [px]

/// With a colour prefilter, the places of the view's colours; otherwise everywhere.
proposal::SearchMask places_for(const prepared::PreparedView& view, const scene::SceneImage& scene,
                                SearchMode mode) {
  if (mode != SearchMode::kColourPrefiltered) return {};
  return view.colour_prefilter.places(scene.classes());
}

/// The best of the sorted candidates at each place: at most `most`, at least `apart` [px] from each
/// other.
std::vector<templates::Candidate> best_places(const std::vector<templates::Candidate>& candidates,
                                              double apart, std::size_t most) {
  std::vector<templates::Candidate> places;
  for (const auto& candidate : candidates) {
    if (!templates::is_near(candidate.pose.position(), places, apart)) places.push_back(candidate);
    if (places.size() == most) break;
  }
  return places;
}

class ViewSearch {
 public:
  ViewSearch(const prepared::PreparedObject& object, const prepared::PreparedView& view,
             const scene::SceneImage& scene, const cv::Rect& roi, SearchMode mode)
      : object_(object),
        view_(view),
        scene_(scene),
        roi_(roi),
        mode_(mode),
        first_(is_reduced(mode) ? kReducedSearch : SearchBudget()),
        proposals_(view, scene, roi, places_for(view, scene, mode)) {}

  std::vector<decision::Detection> run() {
    if (view_.polar) return verify_polar();
    std::vector<templates::Candidate> candidates =
        track_down(view_, scene_, first_, proposals_.by_contour(first_.contour_proposals));
    if (proposals_.everywhere() && !is_certain(candidates))
      merge(track_down(view_, scene_, first_, proposals_.by_correlation(first_.correlated_places)),
            candidates);
    if (may_have_missed(candidates)) search_again(candidates);
    templates::suppress(candidates, {most_at(0), kFinalPruningMargin, apart()});
    try_other_angles(candidates);
    return verify(object_, view_, scene_, hypotheses(view_, scene_, candidates, first_.promising));
  }

 private:
  std::vector<templates::Candidate> likely_places(
      const std::vector<templates::Candidate>& candidates) const {
    auto places = best_places(candidates, apart(), candidates.size());
    templates::drop_below(kMinFoundOdds, places);
    return places;
  }

  /// Whether instances may be missing: the first search found none, or so many that their
  /// candidates may have used up its budget.
  bool may_have_missed(const std::vector<templates::Candidate>& candidates) const {
    if (is_reduced(mode_)) return false;
    return !is_likely(candidates) || likely_places(candidates).size() >= kManyFound;
  }

  /// Follows further proposals, outside the places of found instances, as long as that adds to
  /// many.
  void search_again(std::vector<templates::Candidate>& candidates) {
    constexpr double kNear = 0.35;  // [radii]: proposals of an instance that is already found
    proposals_.search_partial_contours();
    std::vector<templates::Candidate> found;
    if (is_likely(candidates)) found = likely_places(candidates);
    for (;;) {
      merge(track_down(view_, scene_, kFurtherSearch,
                       proposals_.next_by_partial_contour(kFurtherSearch.contour_proposals, found,
                                                          kNear * view_.shape.radius())),
            candidates);
      std::vector<templates::Candidate> more = likely_places(candidates);
      if (more.size() <= found.size() || more.size() < kManyFound) return;
      found = std::move(more);
    }
  }

  void merge(const std::vector<templates::Candidate>& more,
             std::vector<templates::Candidate>& candidates) const {
    candidates.insert(candidates.end(), more.begin(), more.end());
    templates::suppress(candidates,
                        {2 * most_at(0), templates::Suppression::kUnlimited, apart(), alike()});
  }

  double apart() const { return decision::kSamePlace * view_.shape.radius(); }
  templates::DuplicateRadius alike() const { return {1.5, view_.shape.radius()}; }

  /// Whether the best of the sorted candidates is likely, no other place is, and it was among the
  /// first contour proposals, which would then also contain any further instance.
  bool is_certain(const std::vector<templates::Candidate>& candidates) const {
    const auto places = best_places(candidates, apart(), 2);
    if (places.empty() || places[0].value < kMinBestOdds) return false;
    if (places.size() > 1 && places[1].value >= kMaxSecondOdds) return false;
    return proposals_.foremost_by_contour(places[0].pose, kForemost);
  }

  /// Whether the best of the sorted candidates is likely, including the clutter penalty.
  bool is_likely(const std::vector<templates::Candidate>& candidates) const {
    std::vector<double> odds;
    for (const auto& place : best_places(candidates, apart(), candidates.size()))
      odds.push_back(place.value);
    return !odds.empty() && odds.front() - decision::clutter_penalty(odds) >= kMinFoundOdds;
  }

  /// Adds the best other rotations at the best places and wherever an instance is likely:
  /// competitors for the margin, and sometimes the true pose. Each place keeps its best competitor,
  /// even with low odds.
  void try_other_angles(std::vector<templates::Candidate>& candidates) const {
    std::vector<templates::Candidate> needed;
    const auto places = best_places(candidates, 0.5 * view_.shape.radius(), candidates.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i >= kFinal && places[i].value < kLikely) break;
      const auto turned = rotations_at(view_, scene_, places[i]);
      candidates.insert(candidates.end(), turned.begin(), turned.end());
      const auto rival =
          std::find_if(turned.begin(), turned.end(), [&](const templates::Candidate& other) {
            return angle_distance(other.pose.theta, places[i].pose.theta, view_.symmetry) >
                   decision::kOtherAngle;
          });
      const auto shifted = shifts_at(view_, scene_, places[i]);
      needed.insert(needed.end(), shifted.begin(), shifted.end());
      needed.push_back(places[i]);
      if (rival != turned.end()) needed.push_back(*rival);
    }
    templates::suppress(candidates, {most_at(0), kFinalPruningMargin, apart(), alike()});
    candidates.insert(candidates.end(), needed.begin(), needed.end());
    templates::keep_distinct(candidates, candidates.size(), {kSamePose, view_.shape.radius()});
  }

  /// Verifies the poses of the paper's search without aligning them.
  std::vector<decision::Detection> verify_polar() const {
    std::vector<PoseHypothesis> found;
    for (const auto& one : view_.polar->find(scene_.grey, roi_))
      found.push_back(score_as_is(view_, scene_, one.pose));
    return verify(object_, view_, scene_, found);
  }

  const prepared::PreparedObject& object_;
  const prepared::PreparedView& view_;
  const scene::SceneImage& scene_;
  cv::Rect roi_;
  SearchMode mode_;
  SearchBudget first_;
  Proposals proposals_;
};

}  // namespace

std::vector<decision::Detection> search_view(const prepared::PreparedObject& object,
                                             const prepared::PreparedView& view,
                                             const scene::SceneImage& scene, const cv::Rect& roi,
                                             SearchMode mode) {
  return ViewSearch(object, view, scene, roi, mode).run();
}

}  // namespace mbncc::search
