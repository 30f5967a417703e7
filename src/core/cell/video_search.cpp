#include "mbncc/cell/video_search.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "cell/known_instances.hpp"
#include "cell/search_debts.hpp"
#include "mbncc/cell/change_map.hpp"

namespace mbncc {
namespace {

using Clock = std::chrono::steady_clock;
using Names = std::vector<std::string>;

constexpr double kNever = -1e18;     // [s] before any stamp
constexpr double kLeastReach = 16;   // [px] an instance may move between pictures
constexpr double kReachShare = 0.5;  // of the object's radius, likewise
constexpr double kOverhang = 0.35;   // of the radius: a reference point lies so far off a change
constexpr int kMargin = 12;          // [px] about what is looked at
constexpr int kGrid = 16;            // [px] crops begin at multiples, as pyramids like it
constexpr int kLooks = 10;           // searches of an instance at rest, for others to average
constexpr double kLeastCost = 0.25;  // of a search however small the crop, by that of the whole
constexpr double kMostCrop = 0.7;    // share of the picture above which all of it is searched

/// How urgently an object is searched for; the most urgent first.
enum Urgency { kLost, kUnseen, kSeen };

/// What is searched for.
struct Sought {
  std::shared_ptr<const ObjectModel> model;
  double radius = 0;         // [px] of the map about the reference point
  double swept_at = kNever;  // [s]
  bool urgent = true;        // to be swept at once
  bool lost = false;         // an instance has gone missing
};

double radius_of(const ObjectModel& model) {
  double radius = 0;
  for (const auto& view : model.views)
    for (const auto& outline : outlines(view))
      for (const auto& point : outline) radius = std::max(radius, cv::norm(point));
  return radius;
}

bool same_request(const SearchRequest& a, const SearchRequest& b) {
  return a.names == b.names && a.roi == b.roi && a.min_score == b.min_score &&
         a.max_instances == b.max_instances;
}

bool same_limits(const SearchConfig& a, const SearchConfig& b) {
  return a.min_score == b.min_score && a.max_instances == b.max_instances;
}

cv::Rect grown(const cv::Rect& rect, int by) {
  return {rect.x - by, rect.y - by, rect.width + 2 * by, rect.height + 2 * by};
}

cv::Rect square_about(const cv::Point2d& middle, double reach) {
  const int side = 2 * static_cast<int>(std::ceil(reach)) + 1;
  return {cvRound(middle.x) - side / 2, cvRound(middle.y) - side / 2, side, side};
}

void shift(Match& match, cv::Point by) {
  match.pose.x += by.x;
  match.pose.y += by.y;
  for (auto& point : match.outline) point += cv::Point2f(by);
}

double reach_of(const Sought& sought) {
  return std::max(kLeastReach, kReachShare * sought.radius);
}

}  // namespace

struct VideoSearch::State {
  SearchRequest request;
  SearchConfig limits;
  cv::Size size;
  std::vector<std::shared_ptr<const ObjectModel>> objects;  // of the matcher
  ChangeMap changes;
  std::map<std::string, Sought> sought;
  std::vector<Known> known;
  std::vector<Known> hidden;  // gone from where they were while that was still changing
  SearchDebts debts;
  std::map<std::string, double> clutter;  // by name, of the whole picture
  double last_sweep = 0;                  // [s]
};

namespace {

/// One picture being looked at.
template <class State>
class Look {
 public:
  Look(State& state, const VideoConfig& config, const Matcher& matcher, double stamp,
       const cv::Mat& picture)
      : state_(state), config_(config), matcher_(matcher), stamp_(stamp), picture_(picture) {}

  /// The first picture: everything is searched at once.
  SearchResult look_everywhere() {
    take_over_library();
    state_.changes.update(stamp_, picture_);
    state_.last_sweep = stamp_;
    search_everywhere();
    return report();
  }

  SearchResult look_at_changes() {
    take_over_library();
    state_.changes.update(stamp_, picture_);
    for (auto& known : state_.known) known.match.fresh = false;
    if (state_.changes.is_upset() && !state_.changes.settled().empty()) {
      search_everywhere();
      return report();
    }
    note_settled();
    verify_touched();
    look_for_hidden();
    pay_debts(kLost);
    sweep();
    pay_debts(kSeen);
    look_again();
    return report();
  }

 private:
  cv::Rect whole() const { return cv::Rect({0, 0}, picture_.size()); }

  Names all_names() const {
    Names names;
    for (const auto& [name, sought] : state_.sought) names.push_back(name);
    return names;
  }

  /// Objects may have come, changed or gone.
  void take_over_library() {
    auto objects = matcher_.objects();
    if (objects == state_.objects) return;
    state_.objects = std::move(objects);
    std::map<std::string, Sought> before = std::move(state_.sought);
    state_.sought.clear();
    for (const auto& model : state_.objects) {
      if (!is_wanted(*model)) continue;
      const auto known = before.find(model->name);
      if (known != before.end() && known->second.model == model) {
        state_.sought.insert(before.extract(known));
        continue;
      }
      state_.sought[model->name] = {model, radius_of(*model)};
    }
    for (const auto& [name, gone] : before) forget(name);
    for (const auto& [name, sought] : state_.sought)
      if (sought.swept_at == kNever) state_.debts.owe(name, whole());
  }

  bool is_wanted(const ObjectModel& model) const {
    const Names& asked = state_.request.names;
    const bool named =
        asked.empty() || std::find(asked.begin(), asked.end(), model.name) != asked.end();
    return named && model.enabled;
  }

  void forget(const std::string& name) {
    state_.debts.forget(name);
    state_.clutter.erase(name);
    take_out(name, state_.known);
    take_out(name, state_.hidden);
  }

  void search_everywhere() {
    const SearchResult result = search(whole(), all_names());
    state_.known.clear();
    state_.hidden.clear();
    for (const auto& name : result.searched) note_swept(name, result);
    for (const auto& match : result.matches)
      state_.known.push_back({match, match.margin_place, match.margin_place});
  }

  void note_swept(const std::string& name, const SearchResult& result) {
    Sought& sought = state_.sought.at(name);
    sought.swept_at = stamp_;
    sought.urgent = sought.lost = false;
    state_.debts.forget(name);
    const auto clutter = result.clutter.find(name);
    state_.clutter[name] = clutter == result.clutter.end() ? 0 : clutter->second;
  }

  /// Searches for reference points in `region`, in as little of the picture as that takes.
  SearchResult search(const cv::Rect& region, const Names& names) {
    double radius = 0;
    for (const auto& name : names) radius = std::max(radius, state_.sought.at(name).radius);
    const cv::Rect crop = crop_about(region, radius);
    SearchRequest request = state_.request;
    request.names = names;
    cv::Rect roi = region & whole();
    if (!request.roi.empty()) roi &= request.roi;
    SearchResult result;
    if (roi.empty() || names.empty()) {
      result.searched = names;
      return result;
    }
    request.roi = roi - crop.tl();
    if (crop != whole()) request.clutter = state_.clutter;
    result = matcher_.find(picture_(crop), request);
    for (auto& match : result.matches) shift(match, crop.tl());
    for (auto& rival : result.rivals)
      for (auto& point : rival.outline) point += cv::Point2f(crop.tl());
    spent_ += cost_of(names.size(), crop);
    budget_exceeded_ |= result.budget_exceeded;
    return result;
  }

  void note_rivals(const SearchResult& result) {
    for (const auto& rival : result.rivals) note_rival(rival.name, rival.log_odds, rival.outline);
  }

  /// Known instances of other objects lose margin to what is found at their places.
  void note_rival(const std::string& name, double log_odds,
                  const std::vector<cv::Point2f>& outline) {
    for (auto& known : state_.known)
      if (known.match.name != name &&
          outline_overlap(known.match.outline, outline) > matcher_.config().max_overlap)
        known.margin_to_others = std::min(known.margin_to_others, known.match.log_odds - log_odds);
  }

  cv::Rect crop_about(const cv::Rect& region, double radius) const {
    const cv::Rect wanted = grown(region, static_cast<int>(std::ceil(radius)) + kMargin) & whole();
    const cv::Point low(wanted.x / kGrid * kGrid, wanted.y / kGrid * kGrid);
    const cv::Rect crop(low, wanted.br());
    return crop.area() < kMostCrop * whole().area() ? crop : whole();
  }

  /// Places that have come to rest are owed to every object.
  void note_settled() {
    for (const auto& place : state_.changes.settled())
      for (const auto& [name, sought] : state_.sought)
        state_.debts.owe(name, grown(place, cvRound(kOverhang * sought.radius)) & whole());
  }

  void verify_touched() {
    std::vector<Known> touched;
    auto& known = state_.known;
    const auto begin = std::stable_partition(known.begin(), known.end(), [&](const Known& one) {
      return !state_.changes.is_upset() && !state_.changes.touches(one.box());
    });
    touched.assign(std::make_move_iterator(begin), std::make_move_iterator(known.end()));
    known.erase(begin, known.end());
    for (auto& one : touched) {
      one.looks = 0;
      if (is_settled(one.box())) one.margin_to_others = std::numeric_limits<double>::infinity();
    }
    for (const auto& one : touched)
      if (!find_again(one, touched)) state_.hidden.push_back(one);
  }

  /// What was hidden is looked for at its place when something comes to rest about there, for the
  /// last time when the place is on record again, as before or otherwise.
  void look_for_hidden() {
    const std::vector<Known> before = std::move(state_.hidden);
    state_.hidden.clear();
    for (const auto& one : before) {
      const bool changing = state_.changes.touches(one.box());
      const bool found = (!changing || is_settled(one.box())) && find_again(one, before);
      if (changing && !found) state_.hidden.push_back(one);
    }
  }

  bool is_settled(const cv::Rect& box) const {
    const auto& settled = state_.changes.settled();
    return std::any_of(settled.begin(), settled.end(),
                       [&](const cv::Rect& place) { return !(place & box).empty(); });
  }

  /// Looks for an instance near where it was.
  bool find_again(const Known& one, const std::vector<Known>& before) {
    const std::string& name = one.match.name;
    const double reach = reach_of(state_.sought.at(name));
    const auto result = search(square_about(one.match.pose.position(), reach), {name});
    bool found = false;
    for (const auto& match : result.matches) {
      admit(match, before);
      found |= is_continued(one.match, match, reach);
    }
    note_rivals(result);
    state_.sought.at(name).lost = !found;
    return found;
  }

  /// Once in a while each object is searched everywhere, in turn; one that was found at a new place
  /// at once, for its competitors.
  void sweep() {
    if (state_.sought.empty()) return;
    const auto longest = std::min_element(
        state_.sought.begin(), state_.sought.end(), [](const auto& a, const auto& b) {
          return std::make_pair(!a.second.urgent, a.second.swept_at) <
                 std::make_pair(!b.second.urgent, b.second.swept_at);
        });
    const double turn = config_.sweep_time / static_cast<double>(state_.sought.size());
    const bool due = stamp_ - state_.last_sweep >= turn;
    if (!due && !(longest->second.urgent && spent_ < config_.effort)) return;
    if (due) state_.last_sweep = stamp_;
    sweep_for(longest->first);
  }

  void sweep_for(const std::string& name) {
    const SearchResult result = search(whole(), {name});
    if (result.searched.empty()) return;
    note_swept(name, result);
    const std::vector<Known> before = take_out(name, state_.known);
    for (const auto& match : result.matches) {
      Known* admitted = admit(match, before);
      if (admitted) admitted->margin_elsewhere = match.margin_place;
    }
    note_rivals(result);
  }

  static std::vector<Known> take_out(const std::string& name, std::vector<Known>& known) {
    std::vector<Known> taken;
    const auto begin = std::stable_partition(
        known.begin(), known.end(), [&](const Known& one) { return one.match.name != name; });
    taken.assign(std::make_move_iterator(begin), std::make_move_iterator(known.end()));
    known.erase(begin, known.end());
    return taken;
  }

  /// Within the effort, for the objects that are at least as urgent.
  void pay_debts(Urgency least) {
    const auto urgency = [this](const std::string& name) { return urgency_of(name); };
    while (spent_ < config_.effort) {
      const auto due = state_.debts.next(urgency);
      if (!due || urgency_of(due->name) > least) return;
      const SearchResult result = search(due->region, {due->name});
      if (result.searched.empty()) return;
      for (const auto& match : result.matches) admit(match, state_.known);
      note_rivals(result);
      state_.debts.pay(due->name, due->region);
    }
  }

  Urgency urgency_of(const std::string& name) const {
    if (state_.sought.at(name).lost) return kLost;
    const auto& known = state_.known;
    const bool seen = std::any_of(known.begin(), known.end(),
                                  [&](const Known& one) { return one.match.name == name; });
    return seen ? kSeen : kUnseen;
  }

  /// In searches of one object in the whole picture.
  double cost_of(std::size_t objects, const cv::Rect& crop) const {
    const double share = static_cast<double>(crop.area()) / whole().area();
    return static_cast<double>(objects) * (kLeastCost + (1 - kLeastCost) * share);
  }

  /// Instances at rest are searched a few times more, for those who average.
  void look_again() {
    if (spent_ > 0) return;
    auto& known = state_.known;
    const auto least =
        std::min_element(known.begin(), known.end(),
                         [](const Known& a, const Known& b) { return a.looks < b.looks; });
    if (least == known.end() || least->looks >= kLooks) return;
    const std::vector<Known> before{*least};
    known.erase(least);
    find_again(before.front(), before);
  }

  /// Takes a match among the known instances, unless a better one lies there. `before` may hold the
  /// same instance as it was known.
  Known* admit(const Match& match, const std::vector<Known>& before) {
    Known found{match};
    const Known* origin = predecessor(before, match, reach_of(state_.sought.at(match.name)));
    const bool is_new = origin == nullptr;
    if (!is_new) {
      found.margin_elsewhere = origin->margin_elsewhere;
      found.margin_to_others = origin->margin_to_others;
      found.looks = origin->looks + 1;
    }
    if (!make_room(found)) return nullptr;
    if (is_new) announce(match);
    state_.known.push_back(found);
    return &state_.known.back();
  }

  /// False when a better instance lies at the place; else weaker ones are gone.
  bool make_room(Known& found) {
    const Match& match = found.match;
    const double reach = reach_of(state_.sought.at(match.name));
    const auto covers = [&](const Known& one) {
      return outline_overlap(one.match.outline, match.outline) > matcher_.config().max_overlap;
    };
    const auto beats = [&](const Known& one) {
      return covers(one) && !is_continued(one.match, match, reach) &&
             one.match.score >= match.score;
    };
    note_rival(match.name, match.log_odds, match.outline);
    auto& known = state_.known;
    if (std::any_of(known.begin(), known.end(), beats)) return false;
    for (const auto& one : known)
      if (one.match.name != match.name && covers(one))
        found.margin_to_others =
            std::min(found.margin_to_others, match.log_odds - one.match.log_odds);
    known.erase(std::remove_if(known.begin(), known.end(), covers), known.end());
    return true;
  }

  /// An instance at a new place is compared with all objects there, and with all of the picture.
  void announce(const Match& match) {
    state_.sought.at(match.name).lost = false;
    state_.sought.at(match.name).urgent = true;
    for (const auto& [name, sought] : state_.sought)
      if (name != match.name) state_.debts.owe(name, cv::boundingRect(match.outline) & whole());
  }

  SearchResult report() const {
    SearchResult result;
    for (const auto& [name, sought] : state_.sought)
      if (state_.debts.owes(name))
        result.skipped.push_back(name + ": not yet searched where the picture changed");
      else
        result.searched.push_back(name);
    for (const auto& name : state_.request.names)
      if (!state_.sought.count(name)) result.skipped.push_back(name + ": unknown or disabled");
    for (const auto& known : state_.known) result.matches.push_back(judged(known));
    std::stable_sort(result.matches.begin(), result.matches.end(),
                     [](const Match& a, const Match& b) { return a.score > b.score; });
    result.budget_exceeded = budget_exceeded_;
    return result;
  }

  /// The match with all that is known about its competitors.
  Match judged(const Known& known) const {
    const SearchConfig& config = matcher_.config();
    Match match = known.match;
    const bool searched = std::isfinite(known.margin_elsewhere);
    match.margin_place = std::min(match.margin_place, known.margin_to_others);
    if (searched) match.margin_place = std::min(match.margin_place, known.margin_elsewhere);
    const bool sure = match.margin_place >= config.min_margin_place;
    match.graspable = match.graspable && searched && sure && !state_.debts.is_open(known.box());
    match.ambiguous = match.ambiguous || (match.score >= config.confirm_score && !sure);
    return match;
  }

  State& state_;
  const VideoConfig& config_;
  const Matcher& matcher_;
  const double stamp_;
  const cv::Mat& picture_;
  double spent_ = 0;  // searches of one object in a whole picture
  bool budget_exceeded_ = false;
};

}  // namespace

VideoSearch::VideoSearch(VideoConfig config) : config_(config) {}
VideoSearch::~VideoSearch() = default;
VideoSearch::VideoSearch(VideoSearch&&) noexcept = default;
VideoSearch& VideoSearch::operator=(VideoSearch&&) noexcept = default;

void VideoSearch::reset() {
  state_.reset();
}

SearchResult VideoSearch::find(const Matcher& matcher, double stamp, const cv::Mat& picture,
                               const SearchRequest& request) {
  if (config_.sweep_time <= 0) return matcher.find(picture, request);
  const auto start = Clock::now();
  const bool anew = !state_ || state_->size != picture.size() ||
                    !same_request(state_->request, request) ||
                    !same_limits(state_->limits, matcher.config());
  if (anew) {
    state_ = std::make_unique<State>();
    state_->request = request;
    state_->limits = matcher.config();
    state_->size = picture.size();
  }
  Look<State> look(*state_, config_, matcher, stamp, picture);
  SearchResult result = anew ? look.look_everywhere() : look.look_at_changes();
  result.search_time = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace mbncc
