// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/frame_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "imaging/rectangles.hpp"
#include "matching/scene/grey_image.hpp"

namespace mbncc::incremental_search {
namespace {

constexpr int kMostSearches = 10;  // searches for an instance at rest, whose poses are averaged
// [s] An instance at rest is searched for again after this time. The change map does not detect a
// creeping object, or only after some pixels if its contrast is low in noise.
constexpr double kSearchEvery = 0.5;

cv::Rect square_about(const cv::Point2d& middle, double reach) {
  const int side = 2 * static_cast<int>(std::ceil(reach)) + 1;
  return {cvRound(middle.x) - side / 2, cvRound(middle.y) - side / 2, side, side};
}

/// The objects are searched for one at a time, but scored as in a joint search. The region of the
/// request only selects what is reported, of all known instances.
SearchRequest one_by_one(const Matcher& matcher, const cv::Mat& image, SearchRequest request) {
  const auto objects = request.names.empty() ? matcher.objects().size() : request.names.size();
  request.among = std::max(request.among, objects);
  if (!request.roi.empty()) request.max_instances = std::numeric_limits<int>::max();
  request.roi = {};
  request.is_grey = scene::is_grey(image);
  return request;
}

bool is_within(const cv::Rect& inner, const cv::Rect& outer) {
  return (inner & outer) == inner;
}

/// A search takes the best known instance elsewhere into account, so the best are searched first.
void best_first(std::vector<Instance>& instances) {
  std::stable_sort(instances.begin(), instances.end(), [](const Instance& a, const Instance& b) {
    return a.match.odds.uncalibrated() > b.match.odds.uncalibrated();
  });
}

}  // namespace

FrameSearch::FrameSearch(SearchMemory& memory, const VideoConfig& config, const Matcher& matcher,
                         double stamp, const cv::Mat& image)
    : memory_(memory),
      config_(config),
      matcher_(matcher),
      stamp_(stamp),
      search_(matcher, image, one_by_one(matcher, image, memory.request)) {
  drop_removed_objects(
      memory_.objects.update(matcher.objects(), matcher.unsearchable_in(image.size())));
  for (const auto& [name, object] : memory_.objects.all())
    if (object.swept_at == SearchedObject::kNever) memory_.pending.add(name, everywhere());
  memory_.changes.update(stamp, image);
}

/// Places occupied by objects that are no longer searched for must be searched again.
void FrameSearch::drop_removed_objects(const std::vector<std::string>& gone) {
  for (const auto& name : gone) {
    for (const auto& one : memory_.instances.all())
      if (one.match.name == name) schedule_place(one);
    memory_.forget(name);
    for (auto& one : memory_.instances.all()) one.others.erase(name);
  }
}

SearchResult FrameSearch::search_whole_image() {
  memory_.last_sweep = stamp_;
  rebuild_instances();
  return report_of(memory_, matcher_.config(), search_.budget_exceeded());
}

SearchResult FrameSearch::search_changes() {
  for (auto& instance : memory_.instances.all()) instance.match.fresh = false;
  const ChangeMap& changes = memory_.changes;
  if (changes.has_changed_globally() && !changes.settled().empty()) return search_whole_image();
  note_settled();
  verify_touched();
  search_overdue();
  search_hidden();
  search_pending(kLost);
  sweep();
  search_pending(kSeen);
  compare_with_open_objects();
  search_again();
  return report_of(memory_, matcher_.config(), search_.budget_exceeded());
}

SearchResult FrameSearch::search(const cv::Rect& region, const std::vector<std::string>& names) {
  return search_.find(region, names, memory_.objects.radius(names), memory_.clutter,
                      best_outside(region, names), others(names));
}

/// Footprints of the known instances of all objects but `names`.
std::vector<Footprint> FrameSearch::others(const std::vector<std::string>& names) const {
  std::vector<Footprint> footprints;
  for (const auto& one : memory_.instances.all()) {
    if (std::find(names.begin(), names.end(), one.match.name) != names.end()) continue;
    cv::Point2f centre;
    float radius = 0;
    cv::minEnclosingCircle(one.match.outline, centre, radius);
    footprints.push_back({{centre, radius}, cv::contourArea(one.match.outline)});
  }
  return footprints;
}

/// Per name, the best log-odds of the known instances outside `region`, which a search of it need
/// not find.
std::map<std::string, double> FrameSearch::best_outside(
    const cv::Rect& region, const std::vector<std::string>& names) const {
  std::map<std::string, double> best;
  for (const auto& one : memory_.instances.all()) {
    const bool asked = std::find(names.begin(), names.end(), one.match.name) != names.end();
    if (!asked || !(one.box() & region).empty()) continue;
    const auto entry = best.try_emplace(one.match.name, one.match.odds.uncalibrated()).first;
    entry->second = std::max(entry->second, one.match.odds.uncalibrated());
  }
  return best;
}

/// Compares the known instances with the result of a search of `region`.
void FrameSearch::compare(const SearchResult& result, const cv::Rect& region) {
  std::vector<Rival> found = result.rivals;
  for (const auto& match : result.matches) found.push_back(rival_of(match));
  for (const auto& name : result.searched)
    memory_.instances.compare(
        name, found, [&](const cv::Rect& box) { return is_within(touching(box, name), region); });
}

void FrameSearch::rebuild_instances() {
  const SearchResult result = search(everywhere(), memory_.objects.names());
  memory_.instances.all().clear();
  memory_.hidden.clear();
  for (const auto& name : memory_.objects.names()) {
    memory_.pending.add(name, everywhere());  // in case the time budget ended before it
    memory_.objects.at(name).urgent = true;
  }
  for (const auto& name : result.searched) note_swept(name, result);
  for (const auto& match : result.matches) {
    memory_.instances.all().push_back(instance_from(match));
    memory_.instances.all().back().compared_elsewhere = true;
  }
  compare(result, everywhere());
}

void FrameSearch::note_swept(const std::string& name, const SearchResult& result) {
  SearchedObject& object = memory_.objects.at(name);
  object.swept_at = stamp_;
  object.urgent = object.lost = false;
  memory_.pending.forget(name);
  const auto clutter = result.clutter.find(name);
  memory_.clutter[name] = clutter == result.clutter.end() ? 0 : clutter->second;
}

/// Places that have come to rest must be searched for every object.
void FrameSearch::note_settled() {
  for (const auto& place : memory_.changes.settled())
    for (const auto& [name, object] : memory_.objects.all())
      memory_.pending.add(name, imaging::grown(place, cvCeil(object.overhang)));
}

bool FrameSearch::is_settled(const cv::Rect& box) const {
  const auto& settled = memory_.changes.settled();
  return std::any_of(settled.begin(), settled.end(),
                     [&](const cv::Rect& place) { return !(place & box).empty(); });
}

/// An instance that has not been compared with other objects yet: of the match's competitors, only
/// those of its own name are kept.
Instance FrameSearch::instance_from(const Match& match) const {
  Instance instance;
  instance.match = match;
  auto& own = instance.match.competitors;
  own.erase(
      std::remove_if(own.begin(), own.end(),
                     [&](const Competitor& competitor) { return competitor.name != match.name; }),
      own.end());
  instance.in_motion = is_in_motion(instance.box());
  instance.searched_at = stamp_;
  return instance;
}

bool FrameSearch::is_in_motion(const cv::Rect& box) const {
  return memory_.changes.touches(box) && !is_settled(box);
}

void FrameSearch::verify_touched() {
  const ChangeMap& changes = memory_.changes;
  // Results obtained during motion are valid for that image only.
  std::vector<Instance> touched = memory_.instances.take([&](const Instance& one) {
    return changes.has_changed_globally() || one.in_motion || changes.touches(one.box());
  });
  for (auto& one : touched) {
    one.searches = 0;
    one.others.clear();
    if (is_settled(one.box())) schedule_place(one);
  }
  best_first(touched);
  for (const auto& one : touched)
    if (!find_again(one, touched)) memory_.hidden.push_back(one);
}

/// A hidden instance is searched for at its place when something comes to rest there, which is then
/// searched for all objects as well, or when the place matches the reference again. Instances that
/// were seen meanwhile were not compared with it.
void FrameSearch::search_hidden() {
  std::vector<Instance> before = std::exchange(memory_.hidden, {});
  best_first(before);
  for (const auto& one : before) {
    if (is_in_motion(one.box()))
      memory_.hidden.push_back(one);
    else if (find_again(one, before))
      memory_.objects.at(one.match.name).urgent = true;
  }
}

/// Searches for an instance near its last place.
bool FrameSearch::find_again(const Instance& one, const std::vector<Instance>& before) {
  SearchedObject& object = memory_.objects.at(one.match.name);
  const auto region = square_about(one.match.pose.position(), object.reach());
  const SearchResult result = search(region, {one.match.name});
  bool found = false;
  for (const auto& match : result.matches) {
    admit(match, before);
    found |= is_continued(one.match, match, object.reach());
  }
  compare(result, region);
  object.lost = !found;
  return found;
}

/// Periodically searches the whole image for one object after the other; for an object that was
/// found at a new place it does so at once, to find its competitors.
void FrameSearch::sweep() {
  if (memory_.objects.all().empty()) return;
  const double turn = config_.sweep_time / static_cast<double>(memory_.objects.all().size());
  if (stamp_ - memory_.last_sweep >= turn) {
    memory_.last_sweep = stamp_;
    sweep_for(memory_.objects.longest_unswept());
  }
  const auto urgent = memory_.objects.most_urgent();
  if (urgent && search_.spent() < config_.max_search_cost) sweep_for(*urgent);
}

void FrameSearch::sweep_for(const std::string& name) {
  const SearchResult result = search(everywhere(), {name});
  if (result.searched.empty()) return;
  note_swept(name, result);
  const auto before =
      memory_.instances.take([&](const Instance& one) { return one.match.name == name; });
  for (const auto& match : result.matches) {
    Instance* admitted = admit(match, before);
    if (!admitted) continue;
    admitted->compared_elsewhere = true;
    admitted->elsewhere.reset();
  }
  compare(result, everywhere());
}

/// Searches the pending regions of objects of at least this urgency, within max_search_cost.
void FrameSearch::search_pending(Urgency least) {
  const auto urgency = [this](const std::string& name) { return urgency_of(name); };
  while (search_.spent() < config_.max_search_cost) {
    const auto due = memory_.pending.next(urgency);
    if (!due || urgency_of(due->name) > least) return;
    search_uncompared(due->name, due->region);
    const SearchResult result = search(due->region, {due->name});
    if (result.searched.empty()) return;
    const std::vector<Instance> before = memory_.instances.all();
    for (const auto& match : result.matches) admit(match, before);
    compare(result, due->region);
    memory_.pending.complete(due->name, due->region);
  }
}

/// Log-odds are comparable only within one image, so the instances that a search of `region` for
/// `name` is compared with are searched for in this image as well.
void FrameSearch::search_uncompared(const std::string& name, const cv::Rect& region) {
  auto uncompared = memory_.instances.take([&](const Instance& one) {
    return !one.match.fresh && one.match.name != name && one.others.count(name) == 0 &&
           is_within(touching(one.box(), name), region);
  });
  best_first(uncompared);
  for (const auto& one : uncompared) find_again(one, uncompared);
}

FrameSearch::Urgency FrameSearch::urgency_of(const std::string& name) const {
  if (memory_.objects.at(name).lost) return kLost;
  return memory_.instances.shows(name) ? kSeen : kUnseen;
}

/// Compares instances with all objects even while there is motion around them, within
/// max_search_cost.
void FrameSearch::compare_with_open_objects() {
  for (const auto& name : memory_.objects.names())
    for (std::size_t i = 0; i < memory_.instances.all().size(); ++i) {
      if (search_.spent() >= config_.max_search_cost) return;
      const Instance& one = memory_.instances.all()[i];
      if (one.match.name == name || one.others.count(name) > 0) continue;
      const cv::Rect region = touching(one.box(), name);
      search_uncompared(name, region);
      const SearchResult result = search(region, {name});
      const std::vector<Instance> before = memory_.instances.all();
      for (const auto& match : result.matches) admit(match, before);
      compare(result, region);
    }
}

/// Searches again for one of the known instances. Its neighbours may be found as well.
bool FrameSearch::renew(std::vector<Instance>::iterator known) {
  auto& instances = memory_.instances.all();
  const std::vector<Instance> before = instances;
  const Instance earlier = *known;
  instances.erase(known);
  return find_again(earlier, before);
}

/// Searches for the instance whose last search is the longest ago if that is kSearchEvery, and for
/// further ones after twice that time, whatever else is searched in this image. One that is not
/// found may be elsewhere.
void FrameSearch::search_overdue() {
  auto& instances = memory_.instances.all();
  for (double limit = kSearchEvery;; limit = 2 * kSearchEvery) {
    const auto oldest = std::min_element(
        instances.begin(), instances.end(),
        [](const Instance& a, const Instance& b) { return a.searched_at < b.searched_at; });
    if (oldest == instances.end() || stamp_ - oldest->searched_at < limit) return;
    const std::string name = oldest->match.name;
    if (!renew(oldest)) memory_.objects.at(name).urgent = true;
  }
}

/// Instances at rest are searched for a few more times, so that their poses can be averaged.
void FrameSearch::search_again() {
  if (search_.spent() > 0) return;
  auto& instances = memory_.instances.all();
  const auto least = std::min_element(
      instances.begin(), instances.end(),
      [](const Instance& a, const Instance& b) { return a.searches < b.searches; });
  if (least == instances.end() || least->searches >= kMostSearches) return;
  renew(least);
}

/// Adds a match to the known instances; null if a better one is there. `before` may contain the
/// earlier state of the same instance.
Instance* FrameSearch::admit(const Match& match, const std::vector<Instance>& before) {
  const double reach = memory_.objects.at(match.name).reach();
  Instance found = instance_from(match);
  const Instance* origin = predecessor(before, match, reach);
  if (origin) {
    found.inherit_comparisons(*origin);
    found.searches = origin->searches + 1;
  }
  Instance* admitted = memory_.instances.admit(found, reach);
  if (admitted && !origin) schedule_new_instance(*admitted);
  return admitted;
}

/// Schedules the comparison of an instance at a new place with all objects there and with the rest
/// of the image.
void FrameSearch::schedule_new_instance(const Instance& one) {
  SearchedObject& own = memory_.objects.at(one.match.name);
  own.lost = false;
  own.urgent = true;
  schedule_place(one);
}

/// Schedules a search of the instance's place for all other objects.
void FrameSearch::schedule_place(const Instance& one) {
  for (const auto& [name, object] : memory_.objects.all())
    if (name != one.match.name) memory_.pending.add(name, touching(one.box(), name));
}

/// Region [px] of the reference points of all poses of object `name` that may touch `box`.
cv::Rect FrameSearch::touching(const cv::Rect& box, const std::string& name) const {
  return imaging::grown(box, cvCeil(memory_.objects.at(name).radius)) & everywhere();
}

/// Region [px] of the reference points of all poses of all objects that may touch the image.
cv::Rect FrameSearch::everywhere() const {
  return imaging::grown(search_.whole(), cvCeil(memory_.objects.largest_radius()));
}

}  // namespace mbncc::incremental_search
