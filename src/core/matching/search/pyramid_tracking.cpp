// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/pyramid_tracking.hpp"

#include <utility>

#include "imaging/pyramid.hpp"
#include "matching/decision/clutter.hpp"
#include "matching/evidence/contour_alignment.hpp"
#include "matching/search/pose_hypothesis.hpp"

namespace mbncc::search {
namespace {

/// Log-odds below which no candidate became a detection or a relevant competitor.
struct PruningThresholds {
  double roughly, entering, aligned, finally;
};
constexpr PruningThresholds kThresholds{-20, -12, -8, -6};

void step_down(std::vector<templates::Candidate>& candidates) {
  for (auto& candidate : candidates) {
    candidate.pose = imaging::from_level(candidate.pose, 1);
    --candidate.level;
  }
}

class PyramidTracker {
 public:
  PyramidTracker(const prepared::PreparedView& view, const scene::SceneImage& scene,
                 const SearchBudget& budget)
      : view_(view), scene_(scene), budget_(budget) {}

  std::vector<templates::Candidate> run(std::vector<templates::Candidate> candidates) const {
    if (candidates.empty()) return {};
    int level = candidates.front().level;
    enter(level, candidates);
    align(level, 3, candidates);
    for (; level > 0; --level) {
      step_down(candidates);
      align(level - 1, 2, candidates);
    }
    return candidates;
  }

 private:
  /// Scores proposals, first with a coarse template, because reading the surface is expensive and
  /// most proposals are wrong.
  void enter(int level, std::vector<templates::Candidate>& candidates) const {
    keep_best_by_contour(level, candidates);
    score(view_.rough[level], 0, candidates);
    templates::suppress(candidates, {budget_.judged});
    templates::drop_below(kThresholds.roughly, candidates);
    score(view_.tracked[level], 0, candidates);
    templates::suppress(candidates, {budget_.entering, kPruningMargin});
    templates::drop_below(kThresholds.entering, candidates);
  }

  /// Keeps the best candidates by the contour alone.
  void keep_best_by_contour(int level, std::vector<templates::Candidate>& candidates) const {
    if (candidates.size() <= budget_.best_by_contour) return;
    const templates::PoseTemplate& object = view_.rough[level];
    for (auto& candidate : candidates)
      candidate.value =
          evidence::ContourAlignment(object.contour,
                                     scene_.levels[level].around(candidate.pose, object.reach()))
              .at(candidate.pose);
    templates::sort_by_value(candidates);
    candidates.resize(budget_.best_by_contour);
  }

  /// Aligns the candidates in `iterations` steps and computes their log-odds.
  void score(const templates::PoseTemplate& object, int iterations,
             std::vector<templates::Candidate>& candidates) const {
    for (auto& candidate : candidates) {
      const PoseHypothesis reached =
          aligned_from(view_, object, scene_.levels[candidate.level], candidate.pose, iterations);
      candidate.pose = reached.pose;
      candidate.value = reached.odds;
    }
  }

  void align(int level, int iterations, std::vector<templates::Candidate>& candidates) const {
    score(view_.tracked[level], iterations, candidates);
    const std::size_t kept = budget_.kept * most_at(level);
    templates::suppress(candidates, {kept, kPruningMargin, apart_at(level),
                                     alike_at(level, level == 0 ? 1.5 : 1.0)});
    templates::drop_below(level > 0 ? kThresholds.aligned : kThresholds.finally, candidates);
  }

  double radius_at(int level) const { return view_.shape.radius() / (1 << level); }
  double apart_at(int level) const { return decision::kSamePlace * radius_at(level); }

  /// Rotations of a round object are duplicates. Other symmetries do not count, because a print may
  /// break them.
  templates::DuplicateRadius alike_at(int level, double distance) const {
    return {distance, radius_at(level), view_.symmetry == 0 ? 0 : 1};
  }

  const prepared::PreparedView& view_;
  const scene::SceneImage& scene_;
  const SearchBudget& budget_;
};

}  // namespace

std::size_t most_at(int level) {
  return level == 0 ? 8 : level == 1 ? 12 : 20;
}

std::vector<templates::Candidate> track_down(const prepared::PreparedView& view,
                                             const scene::SceneImage& scene,
                                             const SearchBudget& budget,
                                             std::vector<templates::Candidate> proposed) {
  return PyramidTracker(view, scene, budget).run(std::move(proposed));
}

}  // namespace mbncc::search
