// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/instance_list.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "imaging/filled_outline.hpp"
#include "matching/decision/conclusion.hpp"
#include "matching/decision/detection.hpp"

namespace mbncc::incremental_search {
namespace {

/// Distance [px] of the reference points, at equivalent poses.
double distance(const Match& before, const Match& now) {
  const Pose2D pose = equivalent_towards(before.pose.theta, now).pose;
  return cv::norm(pose.position() - before.pose.position());
}

/// The rival as a competitor, with log-odds on the scale of `match`. The clutter of the two comes
/// from searches at different times, so it reduces the rival's log-odds no more than the match's.
Competitor competitor_of(const Match& match, const Rival& rival) {
  const double less_clutter = std::max(0., rival.odds.clutter - match.odds.clutter);
  const double odds = match.odds.of_competitor(rival.odds, rival.name == match.name);
  return {rival.name, rival.position, odds + less_clutter + match.odds.calibration};
}

}  // namespace

cv::Rect Instance::box() const {
  return cv::boundingRect(match.outline);
}

void Instance::inherit_comparisons(const Instance& before) {
  const double gain = before.searches > 0 ? match.log_odds() - before.match.log_odds() : 0;
  compared_elsewhere = before.compared_elsewhere;
  elsewhere = before.elsewhere;
  others = before.others;
  if (elsewhere) elsewhere->log_odds += gain;
  for (auto& [name, best] : others)
    if (best) best->log_odds += gain;
}

Match Instance::judged(const std::vector<std::string>& names, const SearchConfig& config) const {
  Match result = match;
  if (elsewhere) result.competitors.push_back(*elsewhere);
  for (const auto& [name, best] : others)
    if (best) result.competitors.push_back(*best);
  const auto is_open = [this](const std::string& name) {
    return name != match.name && others.count(name) == 0;
  };
  const auto open = std::find_if(names.begin(), names.end(), is_open);
  if (open != names.end()) result.doubts.push_back({false, "not yet compared with " + *open});
  if (!compared_elsewhere) result.doubts.push_back({false, "not yet compared with other places"});
  decision::conclude(result, config);
  // The margin to an object that was not searched for is unknown.
  if (open != names.end() || !compared_elsewhere)
    result.margin_place = std::min(0., result.margin_place);
  return result;
}

Rival rival_of(const Match& match) {
  return {match.name, match.pose.position(), match.odds, match.outline};
}

double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b) {
  const cv::Rect box_a = cv::boundingRect(a), box_b = cv::boundingRect(b);
  if ((box_a & box_b).empty()) return 0;
  const cv::Rect both = box_a | box_b;
  const cv::Mat area_a = imaging::filled(a, both), area_b = imaging::filled(b, both);
  const int smaller = std::min(cv::countNonZero(area_a), cv::countNonZero(area_b));
  return smaller > 0 ? static_cast<double>(cv::countNonZero(area_a & area_b)) / smaller : 0;
}

bool is_continued(const Match& before, const Match& now, double reach) {
  return before.name == now.name && distance(before, now) <= reach;
}

const Instance* predecessor(const std::vector<Instance>& before, const Match& now, double reach) {
  const Instance* nearest = nullptr;
  for (const auto& instance : before) {
    if (!is_continued(instance.match, now, reach)) continue;
    if (!nearest || distance(instance.match, now) < distance(nearest->match, now))
      nearest = &instance;
  }
  return nearest;
}

bool InstanceList::shows(const std::string& name) const {
  return std::any_of(instances_.begin(), instances_.end(),
                     [&](const Instance& one) { return one.match.name == name; });
}

Instance* InstanceList::admit(Instance found, double reach) {
  const Match& match = found.match;
  const auto covers = [&](const Instance& one) {
    return outline_overlap(one.match.outline, match.outline) > max_overlap_;
  };
  const auto beats = [&](const Instance& one) {
    return covers(one) && !is_continued(one.match, match, reach) && one.match.score >= match.score;
  };
  if (std::any_of(instances_.begin(), instances_.end(), beats)) return nullptr;
  // A replaced pose of another object is no comparison with it, and ends an inherited one: the
  // object may fit better nearby. Log-odds from an earlier image are not comparable.
  for (const auto& one : take(covers)) {
    if (one.match.name == match.name) continue;
    found.others.erase(one.match.name);
    if (one.match.fresh)
      found.match.competitors.push_back(competitor_of(match, rival_of(one.match)));
  }
  instances_.push_back(std::move(found));
  return &instances_.back();
}

void InstanceList::compare(Instance& instance, const Rival& rival) const {
  const bool same = instance.match.name == rival.name;
  const bool here = outline_overlap(instance.match.outline, rival.outline) > decision::kOnePlace;
  if (same ? here || !rival.in_part || is_explained(rival) : !here) return;
  std::optional<Competitor>* best = &instance.elsewhere;
  if (!same) {
    const auto compared = instance.others.find(rival.name);
    if (compared == instance.others.end()) return;
    best = &compared->second;
  }
  const auto competitor = competitor_of(instance.match, rival);
  if (!*best || competitor.log_odds > (*best)->log_odds) *best = competitor;
}

bool InstanceList::is_explained(const Rival& rival) const {
  return std::any_of(instances_.begin(), instances_.end(), [&](const Instance& one) {
    return outline_overlap(one.match.outline, rival.outline) > decision::kOnePlace;
  });
}

}  // namespace mbncc::incremental_search
