#include "cell/video_look.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace mbncc {
namespace {

constexpr double kOverhang = 0.35;  // of the radius: a reference point lies so far off a change
constexpr int kLooks = 10;          // searches of an instance at rest, for others to average

cv::Rect square_about(const cv::Point2d& middle, double reach) {
  const int side = 2 * static_cast<int>(std::ceil(reach)) + 1;
  return {cvRound(middle.x) - side / 2, cvRound(middle.y) - side / 2, side, side};
}

/// Objects are searched one by one, but none harder than if all were searched at once.
SearchRequest one_by_one(const Matcher& matcher, SearchRequest request) {
  const auto objects = request.names.empty() ? matcher.objects().size() : request.names.size();
  request.sparing |= objects > kFewObjects;
  return request;
}

}  // namespace

VideoLook::VideoLook(VideoMemory& memory, const VideoConfig& config, const Matcher& matcher,
                     double stamp, const cv::Mat& picture)
    : memory_(memory),
      config_(config),
      matcher_(matcher),
      stamp_(stamp),
      search_(matcher, picture, one_by_one(matcher, memory.request)) {
  give_up(memory_.sought.update(matcher.objects()));
  for (const auto& [name, sought] : memory_.sought.all())
    if (sought.swept_at == Sought::kNever) memory_.debts.owe(name, search_.whole());
  memory_.changes.update(stamp, picture);
}

/// What objects that are no longer sought kept away from their places, or contested, is judged
/// anew.
void VideoLook::give_up(const std::vector<std::string>& gone) {
  for (const auto& name : gone) {
    for (const auto& one : memory_.known.all())
      if (one.match.name == name) owe_place(one.match);
    memory_.forget(name);
  }
  if (gone.empty()) return;
  for (auto& one : memory_.known.all()) {
    if (one.margin_to_others >= matcher_.config().min_margin_place) continue;
    one = Known{one.match};
    announce(one.match);
  }
}

SearchResult VideoLook::look_everywhere() {
  memory_.last_sweep = stamp_;
  search_everywhere();
  return report_of(memory_, matcher_.config(), search_.budget_exceeded());
}

SearchResult VideoLook::look_at_changes() {
  for (auto& known : memory_.known.all()) known.match.fresh = false;
  const ChangeMap& changes = memory_.changes;
  if (changes.is_upset() && !changes.settled().empty()) return look_everywhere();
  note_settled();
  verify_touched();
  look_for_hidden();
  pay_debts(kLost);
  sweep();
  pay_debts(kSeen);
  look_again();
  return report_of(memory_, matcher_.config(), search_.budget_exceeded());
}

SearchResult VideoLook::search(const cv::Rect& region, const std::vector<std::string>& names) {
  return search_.find(region, names, memory_.sought.radius(names), memory_.clutter);
}

void VideoLook::search_everywhere() {
  const SearchResult result = search(search_.whole(), memory_.sought.names());
  memory_.known.all().clear();
  memory_.hidden.clear();
  for (const auto& name : result.searched) note_swept(name, result);
  for (const auto& match : result.matches)
    memory_.known.all().push_back({match, match.margin_place, match.margin_place});
}

void VideoLook::note_swept(const std::string& name, const SearchResult& result) {
  Sought& sought = memory_.sought.at(name);
  sought.swept_at = stamp_;
  sought.urgent = sought.lost = false;
  memory_.debts.forget(name);
  const auto clutter = result.clutter.find(name);
  memory_.clutter[name] = clutter == result.clutter.end() ? 0 : clutter->second;
}

/// Places that have come to rest are owed to every object.
void VideoLook::note_settled() {
  for (const auto& place : memory_.changes.settled())
    for (const auto& [name, sought] : memory_.sought.all())
      memory_.debts.owe(name, grown(place, cvRound(kOverhang * sought.radius)) & search_.whole());
}

bool VideoLook::is_settled(const cv::Rect& box) const {
  const auto& settled = memory_.changes.settled();
  return std::any_of(settled.begin(), settled.end(),
                     [&](const cv::Rect& place) { return !(place & box).empty(); });
}

void VideoLook::verify_touched() {
  const ChangeMap& changes = memory_.changes;
  std::vector<Known> touched = memory_.known.take(
      [&](const Known& one) { return changes.is_upset() || changes.touches(one.box()); });
  for (auto& one : touched) {
    one.looks = 0;
    if (is_settled(one.box())) one.margin_to_others = std::numeric_limits<double>::infinity();
  }
  for (const auto& one : touched)
    if (!find_again(one, touched)) memory_.hidden.push_back(one);
}

/// What was hidden is looked for at its place when something comes to rest about there, for the
/// last time when the place is on record again, as before or otherwise.
void VideoLook::look_for_hidden() {
  const std::vector<Known> before = std::exchange(memory_.hidden, {});
  for (const auto& one : before) {
    const bool changing = memory_.changes.touches(one.box());
    const bool found = (!changing || is_settled(one.box())) && find_again(one, before);
    if (changing && !found) memory_.hidden.push_back(one);
  }
}

/// Looks for an instance near where it was.
bool VideoLook::find_again(const Known& one, const std::vector<Known>& before) {
  Sought& sought = memory_.sought.at(one.match.name);
  const auto region = square_about(one.match.pose.position(), sought.reach());
  const SearchResult result = search(region, {one.match.name});
  bool found = false;
  for (const auto& match : result.matches) {
    admit(match, before);
    found |= is_continued(one.match, match, sought.reach());
  }
  memory_.known.note_rivals(result.rivals);
  sought.lost = !found;
  return found;
}

/// Once in a while each object is searched everywhere, in turn; one that was found at a new place
/// at once, for its competitors.
void VideoLook::sweep() {
  const std::string next = memory_.sought.next_to_sweep();
  if (next.empty()) return;
  const double turn = config_.sweep_time / static_cast<double>(memory_.sought.all().size());
  const bool due = stamp_ - memory_.last_sweep >= turn;
  const bool urgent = memory_.sought.at(next).urgent && search_.spent() < config_.effort;
  if (due) memory_.last_sweep = stamp_;
  if (due || urgent) sweep_for(next);
}

void VideoLook::sweep_for(const std::string& name) {
  const SearchResult result = search(search_.whole(), {name});
  if (result.searched.empty()) return;
  note_swept(name, result);
  const auto before = memory_.known.take([&](const Known& one) { return one.match.name == name; });
  for (const auto& match : result.matches) {
    Known* admitted = admit(match, before);
    if (admitted) admitted->margin_elsewhere = match.margin_place;
  }
  memory_.known.note_rivals(result.rivals);
}

/// Within the effort, for the objects that are at least as urgent.
void VideoLook::pay_debts(Urgency least) {
  const auto urgency = [this](const std::string& name) { return urgency_of(name); };
  while (search_.spent() < config_.effort) {
    const auto due = memory_.debts.next(urgency);
    if (!due || urgency_of(due->name) > least) return;
    const SearchResult result = search(due->region, {due->name});
    if (result.searched.empty()) return;
    const std::vector<Known> before = memory_.known.all();
    for (const auto& match : result.matches) admit(match, before);
    memory_.known.note_rivals(result.rivals);
    memory_.debts.pay(due->name, due->region);
  }
}

VideoLook::Urgency VideoLook::urgency_of(const std::string& name) const {
  if (memory_.sought.at(name).lost) return kLost;
  return memory_.known.shows(name) ? kSeen : kUnseen;
}

/// Instances at rest are searched a few times more, for those who average.
void VideoLook::look_again() {
  if (search_.spent() > 0) return;
  auto& known = memory_.known.all();
  const auto least = std::min_element(
      known.begin(), known.end(), [](const Known& a, const Known& b) { return a.looks < b.looks; });
  if (least == known.end() || least->looks >= kLooks) return;
  const std::vector<Known> before{*least};
  known.erase(least);
  find_again(before.front(), before);
}

/// Takes a match among the known instances; null when a better one lies there. `before` may hold
/// the same instance as it was known.
Known* VideoLook::admit(const Match& match, const std::vector<Known>& before) {
  const double reach = memory_.sought.at(match.name).reach();
  Known found{match};
  const Known* origin = predecessor(before, match, reach);
  if (origin) {
    found.margin_elsewhere = origin->margin_elsewhere;
    found.margin_to_others = origin->margin_to_others;
    found.looks = origin->looks + 1;
  }
  Known* admitted = memory_.known.admit(found, reach);
  if (admitted && !origin) announce(match);
  return admitted;
}

/// An instance at a new place is compared with all objects there, and with all of the picture.
void VideoLook::announce(const Match& match) {
  Sought& own = memory_.sought.at(match.name);
  own.lost = false;
  own.urgent = true;
  owe_place(match);
}

/// The place of a match is owed to all other objects.
void VideoLook::owe_place(const Match& match) {
  for (const auto& [name, sought] : memory_.sought.all())
    if (name != match.name)
      memory_.debts.owe(name, cv::boundingRect(match.outline) & search_.whole());
}

}  // namespace mbncc
