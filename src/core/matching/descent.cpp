#include "matching/descent.hpp"

#include <algorithm>
#include <cstdlib>

#include "matching/candidate_odds.hpp"
#include "matching/climb.hpp"
#include "matching/clutter.hpp"
#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

/// Log-odds below which a candidate has never become a detection, nor a rival that matters.
struct Floors {
  double roughly, entering, climbed, finally;
};
constexpr Floors kFloors{-20, -12, -8, -6};

constexpr std::size_t kOnEdges = 600;  // thin proposals that are climbed, at most

void step_down(std::vector<Candidate>& candidates) {
  for (auto& candidate : candidates) {
    candidate.pose = from_level(candidate.pose, 1);
    --candidate.level;
  }
}

class Descent {
 public:
  Descent(const PreparedView& view, const ScenePicture& scene, const Effort& effort)
      : view_(view), scene_(scene), effort_(effort) {}

  std::vector<Candidate> run(CandidatesPerLevel entering) const {
    std::vector<Candidate> candidates;
    bool judged = false;  // what enters
    for (int level = view_.top_level(); level >= 0; --level) {
      const bool fresh = !entering[level].empty();
      if (fresh && level > 0 && view_.geometry.mean_width() < effort_.width * (1 << level)) {
        enter_finer(level, entering);
        judged = true;
      } else {
        if (!judged) judge_roughly(level, entering[level]);
        admit(level, entering[level], candidates);
        judged = false;
      }
      if (fresh)
        climb_from_around(level, candidates);
      else
        climb_on(level, candidates);
      keep_different(level, candidates);
      drop_below((level > 0 ? kFloors.climbed : kFloors.finally) + effort_.demand, candidates);
      if (level > 0) step_down(candidates);
    }
    return candidates;
  }

 private:
  /// Lets proposals in one level finer: what is hardly two pixels wide cannot be judged.
  void enter_finer(int level, CandidatesPerLevel& entering) const {
    auto coarse = std::move(entering[level]);
    step_down(coarse);
    if (is_narrow(view_, effort_))
      follow_contours(level - 1, coarse);
    else
      keep_those_on_edges(level - 1, kOnEdges, coarse);
    climb_roughly(level - 1, 2, coarse);
    auto& finer = entering[level - 1];
    finer.insert(finer.end(), coarse.begin(), coarse.end());
    entering[level].clear();
  }

  /// Reading the surface is dear, and most proposals lie on nothing: keeps the best `most` by their
  /// contour alone.
  void keep_those_on_edges(int level, std::size_t most, std::vector<Candidate>& candidates) const {
    if (candidates.size() <= most) return;
    for (auto& candidate : candidates)
      candidate.value =
          follow_contour(view_.rough[level], scene_.levels[level], candidate.pose, 0).value;
    sort_by_value(candidates);
    candidates.resize(most);
  }

  /// Moves proposals of a narrow outline onto the edges beside them: where steps are as wide as the
  /// object, nothing else can be judged. Climbing is dear, so the best on edges stay.
  void follow_contours(int level, std::vector<Candidate>& candidates) const {
    constexpr int kSteps = 3;
    for (auto& candidate : candidates) {
      const Climbed on_edges =
          follow_contour(view_.rough[level], scene_.levels[level], candidate.pose, kSteps);
      candidate.pose = on_edges.pose;
      candidate.value = on_edges.value;
    }
    drop_duplicates(candidates, {1, radius_at(level), alike_turns()}, kOnEdges);
  }

  void climb_roughly(int level, int iterations, std::vector<Candidate>& candidates) const {
    for (auto& candidate : candidates) {
      const Supported reached =
          climb_to_evidence(view_.rough[level], scene_.levels[level], candidate.pose, iterations);
      candidate.pose = reached.pose;
      candidate.value = log_odds(reached.evidence, view_.shape.area());
    }
  }

  /// Gives those proposed at a level their rough odds, of too many those that lie on edges.
  void judge_roughly(int level, std::vector<Candidate>& candidates) const {
    if (level == view_.edges.level() && is_narrow(view_, effort_)) {
      follow_contours(level, candidates);
      climb_roughly(level, 1, candidates);
      return;
    }
    keep_those_on_edges(level, effort_.on_edges, candidates);
    for (auto& candidate : candidates)
      candidate.value = rough_odds(view_, scene_, level, candidate.pose);
  }

  /// Takes in the best by all evidence of those that have rough odds.
  void admit(int level, std::vector<Candidate>& entering,
             std::vector<Candidate>& candidates) const {
    sort_by_value(entering);
    if (entering.size() > effort_.judged) entering.resize(effort_.judged);
    drop_below(kFloors.roughly + effort_.demand, entering);
    for (auto& candidate : entering)
      candidate.value = candidate_odds(view_, scene_, level, candidate.pose);
    keep_hopeful_places(entering, effort_.entering, kHopeless, apart_at(level));
    drop_below(kFloors.entering + effort_.demand, entering);
    candidates.insert(candidates.end(), entering.begin(), entering.end());
  }

  Candidate climbed(int level, const Candidate& start, int iterations) const {
    const Supported reached =
        climb_to_evidence(view_.templates[level], scene_.levels[level], start.pose, iterations);
    return {reached.pose, level, log_odds(reached.evidence, view_.shape.area())};
  }

  /// Climbs from candidates of another level.
  void climb_on(int level, std::vector<Candidate>& candidates) const {
    constexpr int kIterations = 2;
    for (auto& candidate : candidates) candidate = climbed(level, candidate, kIterations);
  }

  /// Climbs from new candidates, and from beside them: where the coarse steps were too wide, a
  /// climb misses the top. Starts farther off are tried only where the near ones led elsewhere.
  void climb_from_around(int level, std::vector<Candidate>& candidates) const {
    constexpr int kIterations = 3;
    constexpr double kArc = 1.5;  // [px] between the starts near the rim
    const double radius = radius_at(level);
    for (std::size_t i = 0, count = candidates.size(); i < count; ++i) {
      const Candidate start = candidates[i];
      const Candidate first = candidates[i] = climbed(level, start, kIterations);
      bool elsewhere = false;
      for (const int turn : {-1, 1, -2, 2}) {
        if (std::abs(turn) > effort_.turns || (std::abs(turn) > 1 && !elsewhere)) break;
        Candidate turned = start;
        turned.pose.theta += turn * kArc / std::max(3.0, 0.75 * radius);
        turned = climbed(level, turned, kIterations);
        if (same_top(turned.pose, first.pose, radius)) continue;
        elsewhere = true;
        candidates.push_back(turned);
      }
    }
  }

  static bool same_top(const Pose2D& a, const Pose2D& b, double radius) {
    constexpr double kSame = 0.5;  // [px]
    return std::abs(a.x - b.x) < kSame && std::abs(a.y - b.y) < kSame &&
           angle_distance(a.theta, b.theta) * radius < kSame;
  }

  double radius_at(int level) const { return view_.shape.radius() / (1 << level); }

  /// Rotations of what is round are one candidate. Other symmetries may be measured where a print
  /// tells the rotation.
  int alike_turns() const { return view_.symmetry == 0 ? 0 : 1; }

  double apart_at(int level) const { return kSamePlace * radius_at(level); }

  std::size_t kept_at(int level) const {
    return static_cast<std::size_t>(effort_.kept * static_cast<double>(most_at(level)));
  }

  void keep_different(int level, std::vector<Candidate>& candidates) const {
    drop_duplicates(candidates, {level == 0 ? 1.5 : 1.0, radius_at(level), alike_turns()},
                    kept_at(level), apart_at(level));
    keep_hopeful_places(candidates, candidates.size(), kHopeless, apart_at(level));
  }

  const PreparedView& view_;
  const ScenePicture& scene_;
  const Effort& effort_;
};

}  // namespace

std::size_t most_at(int level) {
  return level == 0 ? 8 : level == 1 ? 12 : 20;
}

bool is_narrow(const PreparedView& view, const Effort& effort) {
  constexpr double kSteps = 2;  // of the edge search's places
  const double step = 2 * (1 << view.edges.level());
  return view.geometry.mean_width() < std::min(effort.narrow, kSteps * step);
}

std::vector<Candidate> descend(const PreparedView& view, const ScenePicture& scene,
                               const Effort& effort, CandidatesPerLevel proposed) {
  return Descent(view, scene, effort).run(std::move(proposed));
}

}  // namespace mbncc
