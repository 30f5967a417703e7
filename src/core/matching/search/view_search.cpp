// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/view_search.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "matching/decision/clutter.hpp"
#include "matching/evidence/contour_alignment.hpp"
#include "matching/refinement/gauss_newton.hpp"
#include "matching/search/proposals.hpp"
#include "matching/search/pyramid_tracking.hpp"
#include "matching/search/rotation_peaks.hpp"
#include "matching/search/search_budget.hpp"
#include "matching/search/verification.hpp"

namespace mbncc::search {
namespace {

constexpr std::size_t kFinal = 3;        // places whose other angles are tried, ...
constexpr std::size_t kMostPlaces = 10;  // ... and so many ...
constexpr double kLikely = 0;            // ... that have these log-odds
constexpr double kSamePose = 1e-6;       // [px]
constexpr double kOtherAngle = to_radians(10.);
constexpr std::size_t kPolished = 8;
constexpr double kOutclassed = 8;  // log-odds behind the best: not aligned again

/// A view with a part of the rotations gets proportionally fewer candidates.
template <class Count>
Count part_of(Count count, const proposal::AngleRange& sector) {
  const double share = std::min(1.0, (sector.high - sector.low) / (2 * kPi));
  return static_cast<Count>(std::ceil(share * count));
}

SearchBudget for_sector(SearchBudget budget, const proposal::AngleRange& sector) {
  for (auto* count : {&budget.edge_poses, &budget.on_edges, &budget.judged, &budget.entering})
    *count = part_of(*count, sector);
  return budget;
}

FirstSearch for_sector(FirstSearch first, const proposal::AngleRange& sector) {
  first.budget = for_sector(first.budget, sector);
  first.correlated_places = part_of(first.correlated_places, sector);
  return first;
}

class ViewSearch {
 public:
  ViewSearch(const prepared::PreparedObject& object, const prepared::PreparedView& view,
             const scene::SceneImage& scene, const cv::Rect& roi, SearchMode mode,
             const proposal::SearchMask& places)
      : object_(object),
        view_(view),
        scene_(scene),
        roi_(roi),
        everywhere_(places.everywhere()),
        mode_(mode),
        first_(for_sector(is_sparing(mode) ? kAmongMany : FirstSearch(), view.sector)),
        proposals_(view, scene, roi, places) {}

  std::vector<decision::Detection> run() {
    if (view_.polar) return judge_polar();
    if (view_.top_level() > scene_.top_level()) return {};
    proposals_.follow_edges(first_.budget.edge_poses);
    std::vector<templates::Candidate> candidates = best_by_edges();
    if (everywhere_ && !sure(candidates))
      merge(track_down(view_, scene_, first_.budget,
                       proposals_.by_correlation(first_.correlated_places)),
            candidates);
    if (mode_ == SearchMode::kTwice && !found(candidates))
      merge(best_by_visible_part(), candidates);
    templates::suppress(candidates, {most_at(0), kNoRival, apart()});
    try_other_angles(candidates);
    return judge_all(candidates);
  }

  std::vector<decision::Detection> run_at(const std::vector<cv::Point2d>& centres) const {
    std::vector<templates::Candidate> candidates;
    for (const auto& centre : centres) {
      const auto turned = turned_at({{centre.x, centre.y, 0}, 0, 0});
      candidates.insert(candidates.end(), turned.begin(), turned.end());
    }
    templates::sort_by_value(candidates);
    templates::drop_below(kWorthRefining, candidates);
    return candidates.empty() ? std::vector<decision::Detection>{} : judge_all(candidates);
  }

 private:
  std::vector<templates::Candidate> best_by_edges() const {
    return track_down(view_, scene_, first_.budget, proposals_.by_edges(first_.budget.edge_poses));
  }

  std::vector<templates::Candidate> best_by_visible_part() const {
    const SearchBudget budget = for_sector(kSecondSearch, view_.sector);
    return track_down(view_, scene_, budget, proposals_.by_visible_part(budget.edge_poses));
  }

  void merge(const std::vector<templates::Candidate>& more,
             std::vector<templates::Candidate>& candidates) const {
    candidates.insert(candidates.end(), more.begin(), more.end());
    templates::suppress(candidates,
                        {2 * most_at(0), templates::Suppression::kUnlimited, apart(), alike()});
  }

  double apart() const { return decision::kSamePlace * view_.shape.radius(); }
  templates::DuplicateRadius alike() const { return {1.5, view_.shape.radius()}; }

  /// Whether one of the sorted candidates is likely, no other place is, and it was among the first
  /// contour proposals, which would then also contain a further instance.
  bool sure(const std::vector<templates::Candidate>& candidates) const {
    const auto places = templates::best_places(candidates, apart(), 2);
    if (places.empty() || places[0].value < kCertain) return false;
    if (places.size() > 1 && places[1].value >= kSecond) return false;
    return proposals_.foremost_by_edges(places[0].pose, kForemost);
  }

  /// Whether one of the sorted candidates is likely, including the clutter penalty.
  bool found(const std::vector<templates::Candidate>& candidates) const {
    std::vector<double> odds;
    for (const auto& place : templates::best_places(candidates, apart(), candidates.size()))
      odds.push_back(place.value);
    return !odds.empty() && odds.front() - decision::clutter_penalty(odds) >= kFound;
  }

  /// Adds the best other rotations at the best places and wherever an instance is likely:
  /// competitors for the margin, and sometimes the true pose. Each place keeps its best competitor,
  /// even with low odds.
  void try_other_angles(std::vector<templates::Candidate>& candidates) const {
    std::vector<templates::Candidate> needed;
    const auto places = templates::best_places(candidates, 0.5 * view_.shape.radius(), kMostPlaces);
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (i >= kFinal && places[i].value < kLikely) break;
      const auto turned = turned_at(places[i]);
      candidates.insert(candidates.end(), turned.begin(), turned.end());
      const auto rival =
          std::find_if(turned.begin(), turned.end(), [&](const templates::Candidate& other) {
            return angle_distance(other.pose.theta, places[i].pose.theta, view_.symmetry) >
                   kOtherAngle;
          });
      needed.push_back(places[i]);
      if (rival != turned.end()) needed.push_back(*rival);
    }
    templates::suppress(candidates, {most_at(0), kNoRival, apart(), alike()});
    candidates.insert(candidates.end(), needed.begin(), needed.end());
    templates::suppress(candidates, {candidates.size(),
                                     templates::Suppression::kUnlimited,
                                     templates::Suppression::kUnlimited,
                                     {kSamePose, view_.shape.radius()}});
  }

  /// The best other rotations at a place, best first.
  std::vector<templates::Candidate> turned_at(const templates::Candidate& place) const {
    constexpr std::size_t kMost = 3;
    auto peaks = rotation_peaks(view_.rough[0], scene_.levels[0], place, 2);
    std::vector<templates::Candidate> turned = reached_from(peaks, kMost);
    peaks.insert(peaks.begin(), half_turned(place));
    const auto shifted = reached_from(shifted_onto_edges(peaks), kMost);
    turned.insert(turned.end(), shifted.begin(), shifted.end());
    templates::suppress(turned, {kMost, templates::Suppression::kUnlimited,
                                 templates::Suppression::kUnlimited, alike()});
    return turned;
  }

  /// Half a turn about the map's centroid, where an elongated object covers itself best; this may
  /// be farther than the shifts reach.
  templates::Candidate half_turned(const templates::Candidate& place) const {
    const templates::SurfaceTemplate& surface = view_.templates[0].surface;
    const auto mean = [&](const std::vector<float>& values) {
      return std::accumulate(values.begin(), values.begin() + surface.size(), 0.0) /
             static_cast<double>(surface.size());
    };
    return {compose(place.pose, {2 * mean(surface.x), 2 * mean(surface.y), kPi}), place.level, 0};
  }

  /// The first of these, shifted to the best fit of their outlines, best first: if shading
  /// displaced one rotation by pixels, the other is displaced in the opposite direction.
  std::vector<templates::Candidate> shifted_onto_edges(
      std::vector<templates::Candidate> peaks) const {
    constexpr std::size_t kMost = 6;
    if (peaks.size() > kMost) peaks.resize(kMost);
    for (auto& peak : peaks)
      peak = evidence::shifted_onto_edges(view_.templates[0].contour, scene_.levels[0], peak);
    templates::sort_by_value(peaks);
    return peaks;
  }

  /// The aligned poses of the first `most` of them, by log-odds.
  std::vector<templates::Candidate> reached_from(std::vector<templates::Candidate> starts,
                                                 std::size_t most) const {
    constexpr int kIterations = 5;
    if (starts.size() > most) starts.resize(most);
    for (auto& start : starts) {
      const refinement::ScoredPose reached = refinement::align_and_score(
          view_.templates[0], scene_.levels[0], start.pose, kIterations);
      start.pose = reached.pose;
      start.value = evidence::log_odds(reached.evidence, view_.shape.area());
    }
    return starts;
  }

  /// The paper's poses without alignment, with their evidence.
  std::vector<decision::Detection> judge_polar() const {
    std::vector<PoseHypothesis> found;
    if (view_.polar->top_level() <= scene_.top_level())
      for (const auto& one : view_.polar->find(scene_.grey, roi_))
        found.push_back(score_as_is(view_, scene_, one.pose));
    return verify(object_, view_, scene_, found);
  }

  std::vector<decision::Detection> judge_all(
      const std::vector<templates::Candidate>& candidates) const {
    std::vector<PoseHypothesis> found;
    std::vector<Pose2D> reached;
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const templates::Candidate& candidate = candidates[i];
      if (i >= kPolished || candidate.value <= first_.promising ||
          candidate.value <= candidates.front().value - kOutclassed) {
        found.push_back(score_as_is(view_, scene_, candidate.pose));
        continue;
      }
      const PoseHypothesis top = multistart_align(view_, scene_, candidate.pose);
      if (is_one_of(reached, top.pose)) continue;
      reached.push_back(top.pose);
      found.push_back(top);
    }
    return verify(object_, view_, scene_, found);
  }

  /// Poses nearer than this are refined to one.
  bool is_one_of(const std::vector<Pose2D>& poses, const Pose2D& pose) const {
    constexpr double kAlike = 0.25;  // [px]
    return std::any_of(poses.begin(), poses.end(), [&](const Pose2D& other) {
      return cv::norm(other.position() - pose.position()) < kAlike &&
             angle_distance(other.theta, pose.theta) * view_.shape.radius() < kAlike;
    });
  }

  const prepared::PreparedObject& object_;
  const prepared::PreparedView& view_;
  const scene::SceneImage& scene_;
  cv::Rect roi_;
  bool everywhere_;
  SearchMode mode_;
  FirstSearch first_;
  Proposals proposals_;
};

}  // namespace

std::vector<decision::Detection> search_view(const prepared::PreparedObject& object,
                                             const prepared::PreparedView& view,
                                             const scene::SceneImage& scene, const cv::Rect& roi,
                                             SearchMode mode, const proposal::SearchMask& places) {
  return ViewSearch(object, view, scene, roi, mode, places).run();
}

std::vector<decision::Detection> judge_places(const prepared::PreparedObject& object,
                                              const prepared::PreparedView& view,
                                              const scene::SceneImage& scene,
                                              const std::vector<cv::Point2d>& centres) {
  return ViewSearch(object, view, scene, {}, SearchMode::kQuick, {}).run_at(centres);
}

}  // namespace mbncc::search
