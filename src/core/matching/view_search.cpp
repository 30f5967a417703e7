#include "matching/view_search.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "matching/clutter.hpp"
#include "matching/coarse_search.hpp"
#include "matching/edge_search.hpp"
#include "matching/effort.hpp"
#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kFinal = 3;  // places whose other angles are tried
constexpr std::size_t kPolished = 8;
constexpr double kHopeless = 15;   // log-odds behind the best that no climb makes up for
constexpr double kNoRival = 12;    // log-odds behind the best at full resolution, of no interest
constexpr double kOutclassed = 8;  // log-odds behind the best that polishing does not make up for

/// For a view that is left a part of the rotations, so many fewer candidates.
Effort for_sector(Effort effort, const RotationSector& sector) {
  const double share = std::min(1.0, (sector.high - sector.low) / (2 * kPi));
  const auto part = [share](auto& count) {
    count = static_cast<std::remove_reference_t<decltype(count)>>(std::ceil(share * count));
  };
  part(effort.correlated_places);
  part(effort.edge_poses);
  part(effort.judged);
  part(effort.entering);
  return effort;
}

/// Log-odds below which a candidate has never become a detection, nor a rival that matters.
struct Floors {
  double roughly, entering, climbed, finally;
};
constexpr Floors kFloors{-20, -12, -8, -6};

std::size_t most_at(int level) {
  return level == 0 ? 8 : level == 1 ? 12 : 20;
}

cv::Rect at_level(const cv::Rect& roi, int level) {
  const int side = 1 << level;
  const cv::Point low(roi.x / side, roi.y / side);
  const cv::Point high((roi.br().x + side - 1) / side, (roi.br().y + side - 1) / side);
  return {low, high};
}

class ViewSearch {
 public:
  ViewSearch(const PreparedObject& object, const PreparedView& view, const ScenePicture& scene,
             const cv::Rect& roi, Look look, const Places& places)
      : object_(object),
        view_(view),
        scene_(scene),
        roi_(roi),
        places_(places),
        look_(look),
        first_(for_sector(look == Look::kSparing ? kSparing : kQuick, view.sector)),
        thorough_(for_sector(kThorough, view.sector)) {}

  std::vector<Detection> run() {
    if (view_.polar) return judge_polar();
    if (view_.top_level() > scene_.top_level()) return {};
    follow_edges();
    std::vector<Candidate> candidates = descend(first_, by_edges(first_));
    if (places_.everywhere() && !sure(candidates)) {
      correlate();
      merge(descend(first_, by_correlation()), candidates);
    }
    if (look_ == Look::kTwice && !found(candidates))
      merge(descend(thorough_, by_edges(thorough_)), candidates);
    keep_hopeful(candidates, most_at(0), kNoRival);
    try_other_angles(candidates);
    return judge(candidates);
  }

 private:
  using PerLevel = std::vector<std::vector<Candidate>>;

  /// From what the coarse searches proposed to the best candidates at full resolution.
  std::vector<Candidate> descend(const Effort& effort, PerLevel entering) const {
    std::vector<Candidate> candidates;
    for (int level = view_.top_level(); level >= 0; --level) {
      const bool fresh = !entering[level].empty();
      if (fresh && level > 0 && view_.geometry.mean_width() < effort.width * (1 << level))
        enter_finer(level, entering);
      else
        admit(level, effort, entering[level], candidates);
      refine_at(level, fresh ? 4 : 2, candidates);
      drop_below((level > 0 ? kFloors.climbed : kFloors.finally) + effort.demand, candidates);
      if (level > 0) step_down(candidates);
    }
    return candidates;
  }

  PerLevel by_edges(const Effort& effort) const {
    PerLevel entering(view_.templates.size());
    auto& proposed = entering[view_.edges.level()];
    const std::size_t count = std::min(effort.edge_poses, edges_.size());
    proposed.assign(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(count));
    proposed.insert(proposed.end(), round_.begin(), round_.end());
    return entering;
  }

  PerLevel by_correlation() const {
    PerLevel entering(view_.templates.size());
    entering[view_.kernels.level] = correlated_;
    return entering;
  }

  void merge(const std::vector<Candidate>& more, std::vector<Candidate>& candidates) const {
    candidates.insert(candidates.end(), more.begin(), more.end());
    drop_duplicates(candidates, 1.5, view_.shape.radius(), 2 * most_at(0));
  }

  void correlate() {
    const int level = view_.kernels.level;
    if (level == 0) return;  // too fine to search everywhere; the edges have to do
    CoarseSettings settings;
    settings.max_places = first_.correlated_places;
    correlated_ = coarse_search(view_.kernels, scene_.grey[level], at_level(roi_, level), settings,
                                view_.sector, places_);
  }

  void follow_edges() {
    const int level = view_.edges.level();
    EdgeCandidates found =
        edge_search(view_.edges, scene_.levels[level], at_level(roi_, level),
                    (look_ == Look::kTwice ? thorough_ : first_).edge_poses, view_.sector, places_);
    edges_ = std::move(found.poses);
    for (auto& place : found.round_places) place.value = odds(level, place.pose);
    keep_hopeful(found.round_places, first_.round_places, kHopeless);
    for (const auto& place : found.round_places) add_rotations_by_surface(place, round_);
  }

  /// The best rotations at a place by what the surface looks like.
  void add_rotations_by_surface(const Candidate& place, std::vector<Candidate>& found) const {
    constexpr std::size_t kMost = 4;
    auto peaks = rotation_peaks(view_.rough[place.level], place, 1.5);
    peaks.erase(std::remove_if(peaks.begin(), peaks.end(),
                               [this](const Candidate& peak) {
                                 return !view_.sector.contains(peak.pose.theta);
                               }),
                peaks.end());
    if (peaks.size() > kMost) peaks.resize(kMost);
    found.insert(found.end(), peaks.begin(), peaks.end());
  }

  /// Local maxima of the agreement over a full turn in steps of `arc` [px], best first.
  std::vector<Candidate> rotation_peaks(const PoseTemplate& object, const Candidate& place,
                                        double arc) const {
    const SceneLevel& scene = scene_.levels[place.level];
    const double rim = 2 * kPi * object.surface.radius();
    const int count = std::max(24, static_cast<int>(std::ceil(rim / arc)));
    std::vector<Candidate> turned(count, place);
    for (int k = 0; k < count; ++k) {
      turned[k].pose.theta = wrap_angle(place.pose.theta + 2 * kPi * k / count);
      turned[k].value = climb(object, scene, turned[k].pose, 0).value;
    }
    std::vector<Candidate> peaks;
    for (int k = 0; k < count; ++k)
      if (turned[k].value >= turned[(k + 1) % count].value &&
          turned[k].value > turned[(k + count - 1) % count].value)
        peaks.push_back(turned[k]);
    sort_by_value(peaks);
    return peaks;
  }

  /// Lets proposals in one level finer: what is hardly two pixels wide cannot be judged.
  void enter_finer(int level, PerLevel& entering) const {
    auto coarse = std::move(entering[level]);
    step_down(coarse);
    for (auto& candidate : coarse) {
      candidate.pose =
          climb(view_.rough[level - 1], scene_.levels[level - 1], candidate.pose, 2).pose;
      entering[level - 1].push_back(candidate);
    }
    entering[level].clear();
  }

  void admit(int level, const Effort& effort, std::vector<Candidate>& entering,
             std::vector<Candidate>& candidates) const {
    for (auto& candidate : entering)
      candidate.value = odds(view_.rough[level], level, candidate.pose);
    sort_by_value(entering);
    if (entering.size() > effort.judged) entering.resize(effort.judged);
    drop_below(kFloors.roughly + effort.demand, entering);
    for (auto& candidate : entering) candidate.value = odds(level, candidate.pose);
    keep_hopeful(entering, effort.entering, kHopeless);
    drop_below(kFloors.entering + effort.demand, entering);
    add_turned(effort.turns, entering);
    candidates.insert(candidates.end(), entering.begin(), entering.end());
  }

  /// Starts beside the candidates: where the coarse steps were too wide, a climb misses the top.
  void add_turned(int turns, std::vector<Candidate>& candidates) const {
    constexpr double kArc = 1.5;  // [px] between the starts near the rim
    const std::size_t count = candidates.size();
    for (std::size_t i = 0; i < count; ++i)
      for (int k = -turns; k <= turns; ++k) {
        if (k == 0) continue;
        Candidate turned = candidates[i];
        const double radius = view_.shape.radius() / (1 << turned.level);
        turned.pose.theta += k * kArc / std::max(3.0, 0.75 * radius);
        candidates.push_back(turned);
      }
  }

  double odds(const PoseTemplate& object, int level, const Pose2D& pose) const {
    return log_odds(gather_evidence(object, scene_.levels[level], pose), view_.shape.area());
  }

  double odds(int level, const Pose2D& pose) const {
    return odds(view_.templates[level], level, pose);
  }

  void refine_at(int level, int iterations, std::vector<Candidate>& candidates) const {
    const SceneLevel& scene = scene_.levels[level];
    for (auto& candidate : candidates) {
      candidate.pose = climb(view_.templates[level], scene, candidate.pose, iterations).pose;
      candidate.value = odds(level, candidate.pose);
    }
    drop_duplicates(candidates, level == 0 ? 1.5 : 1.0, view_.shape.radius() / (1 << level),
                    most_at(level));
    keep_hopeful(candidates, most_at(level), kHopeless);
  }

  static void step_down(std::vector<Candidate>& candidates) {
    for (auto& candidate : candidates) {
      candidate.pose = from_level(candidate.pose, 1);
      --candidate.level;
    }
  }

  /// One of the sorted candidates is likely and no other place is, and edges proposed it among the
  /// first: so they would have a further instance.
  bool sure(const std::vector<Candidate>& candidates) const {
    const auto places = best_places(candidates, kSamePlace * view_.shape.radius(), 2);
    if (places.empty() || places[0].value < kSure) return false;
    if (places.size() > 1 && places[1].value >= kSecond) return false;
    return foremost_by_edges(places[0].pose);
  }

  bool foremost_by_edges(const Pose2D& pose) const {
    constexpr double kNear = 2.5;  // [px at the edges' level]
    const cv::Point2d place = to_level(pose.position(), view_.edges.level());
    const std::size_t count = std::min(kForemost, edges_.size());
    return std::any_of(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(count),
                       [&](const Candidate& proposed) {
                         return cv::norm(proposed.pose.position() - place) < kNear;
                       });
  }

  /// One of the sorted candidates is likely, among others of its like, too.
  bool found(const std::vector<Candidate>& candidates) const {
    std::vector<double> odds;
    for (const auto& place : best_places(candidates, kSamePlace * view_.shape.radius(), kCluttered))
      odds.push_back(place.value);
    return !odds.empty() && odds.front() - clutter_discount(odds) >= kFound;
  }

  /// Adds the best other rotations at the best places: rivals that the margin is measured against,
  /// and sometimes the truth.
  void try_other_angles(std::vector<Candidate>& candidates) const {
    constexpr std::size_t kMost = 3;
    for (const auto& place : best_places(candidates, 0.5 * view_.shape.radius(), kFinal)) {
      auto peaks = rotation_peaks(view_.rough[0], place, 2);
      if (peaks.size() > kMost) peaks.resize(kMost);
      for (auto& peak : peaks) {
        peak.pose = climb(view_.templates[0], scene_.levels[0], peak.pose, 5).pose;
        peak.value = odds(0, peak.pose);
        candidates.push_back(peak);
      }
    }
    drop_duplicates(candidates, 1.5, view_.shape.radius(), most_at(0));
    keep_hopeful(candidates, most_at(0), kNoRival);
  }

  /// The paper's poses as they are, with the evidence for them.
  std::vector<Detection> judge_polar() const {
    std::vector<Detection> detections;
    if (view_.polar->top_level() > scene_.top_level()) return detections;
    for (const auto& found : view_.polar->find(scene_.grey, roi_))
      detections.push_back(judge_pose(object_, view_, scene_, found.pose));
    return compare_rotations(std::move(detections));
  }

  std::vector<Detection> judge(const std::vector<Candidate>& candidates) const {
    std::vector<Detection> detections;
    for (const auto& candidate : candidates) {
      const bool polish = detections.size() < kPolished && candidate.value > first_.promising &&
                          candidate.value > candidates.front().value - kOutclassed;
      detections.push_back(polish ? polish_and_judge(object_, view_, scene_, candidate.pose)
                                  : judge_pose(object_, view_, scene_, candidate.pose));
    }
    return compare_rotations(std::move(detections));
  }

  const PreparedObject& object_;
  const PreparedView& view_;
  const ScenePicture& scene_;
  cv::Rect roi_;
  const Places& places_;
  Look look_;
  Effort first_, thorough_;
  // What the coarse searches proposed, each best first.
  std::vector<Candidate> correlated_, edges_, round_;
};

}  // namespace

std::vector<Detection> search_view(const PreparedObject& object, const PreparedView& view,
                                   const ScenePicture& scene, const cv::Rect& roi, Look look,
                                   const Places& places) {
  return ViewSearch(object, view, scene, roi, look, places).run();
}

}  // namespace mbncc
