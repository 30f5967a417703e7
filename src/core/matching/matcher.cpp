// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/matcher.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "matching/decision/conclusion.hpp"
#include "matching/decision/missing_colour.hpp"
#include "matching/decision/report.hpp"
#include "matching/decision/selection.hpp"
#include "matching/prepared/comparison.hpp"
#include "matching/proposal/ncc_search.hpp"
#include "matching/scene/grey_image.hpp"
#include "matching/search/colour_cast.hpp"
#include "matching/search/object_search.hpp"
#include "matching/search/occupied_search.hpp"

namespace mbncc {
namespace {

using Clock = std::chrono::steady_clock;
using ObjectList = std::vector<std::shared_ptr<const prepared::PreparedObject>>;

constexpr int kUnlimited = std::numeric_limits<int>::max();

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::string text(cv::Size size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

/// Calls work(i) for i in [0, count) on up to `threads` threads; rethrows an exception in the
/// caller.
template <class Work>
void in_parallel(std::size_t count, int threads, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto worker = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> helpers;
  const std::size_t wanted = std::min<std::size_t>(static_cast<std::size_t>(threads), count);
  for (std::size_t k = 1; k < wanted; ++k)
    helpers.push_back(std::async(std::launch::async, worker));
  worker();
  for (auto& helper : helpers) helper.get();
}

int top_level(const ObjectList& objects) {
  int top = 0;
  for (const auto& object : objects) top = std::max(top, object->top_level());
  return top;
}

search::SearchMode mode_for(std::size_t objects, const SearchRequest& request,
                            const SearchConfig& config) {
  if (objects > kFewObjects && config.engine != "polar")
    return search::SearchMode::kColourPrefiltered;
  return std::max(objects, request.among) > kFewObjects ? search::SearchMode::kReduced
                                                        : search::SearchMode::kThorough;
}

/// Search results per object.
struct SearchState {
  explicit SearchState(std::size_t objects) : found(objects), searched(objects, 0) {}

  bool complete() const {
    return std::all_of(searched.begin(), searched.end(), [](char done) { return done != 0; });
  }

  std::vector<std::vector<decision::Detection>> found;
  std::vector<char> searched;  ///< 0: not searched in time
};

/// Lists the objects in `result` as searched or skipped for lack of time.
void note_searched(const ObjectList& objects, const SearchState& findings, SearchResult& result) {
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string& name = objects[i]->model->name;
    if (findings.searched[i])
      result.searched.push_back(name);
    else
      result.skipped.push_back(name + ": time budget exceeded");
  }
  result.budget_exceeded = result.searched.size() < objects.size();
}

std::vector<decision::Detection> all_of(const SearchState& findings) {
  std::vector<decision::Detection> all;
  for (const auto& found : findings.found) all.insert(all.end(), found.begin(), found.end());
  return all;
}

/// The likely instances in the image, except those of object `own`.
std::vector<Footprint> occupied_by_others(const SearchState& findings, std::size_t own) {
  constexpr double kLikely = 1;  // log-odds; lower ones never become graspable
  std::vector<Footprint> footprints;
  for (std::size_t i = 0; i < findings.found.size(); ++i) {
    if (i == own) continue;
    for (const auto& one : findings.found[i])
      if (one.log_odds() > kLikely)
        footprints.push_back(
            {{one.pose.position(), one.view->shape.radius()}, cv::contourArea(one.view->outline)});
  }
  return footprints;
}

/// Verifies each object at the places of others, because a search may miss a look-alike, which
/// would then not compete.
void compare_in_place(const std::vector<prepared::Comparison>& comparisons,
                      const SearchRequest& request, SearchState& findings) {
  std::vector<std::vector<decision::Detection>> more(comparisons.size());
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    if (!findings.searched[i]) continue;
    auto occupied = occupied_by_others(findings, i);
    occupied.insert(occupied.end(), request.occupied.begin(), request.occupied.end());
    more[i] = search::search_occupied(*comparisons[i].object, *comparisons[i].scene, occupied,
                                      findings.found[i]);
  }
  for (std::size_t i = 0; i < comparisons.size(); ++i)
    findings.found[i].insert(findings.found[i].end(), more[i].begin(), more[i].end());
}

/// Without a comparison with the objects that were skipped for lack of time, no match is graspable.
void doubt_without_comparison(const ObjectList& objects, const SearchState& findings,
                              const SearchConfig& config, std::vector<Match>& matches) {
  const auto skipped = std::find(findings.searched.begin(), findings.searched.end(), 0);
  if (skipped == findings.searched.end()) return;
  const auto& first = *objects[static_cast<std::size_t>(skipped - findings.searched.begin())];
  for (auto& match : matches) {
    match.doubts.push_back({false, "not compared with " + first.model->name + ": time budget"});
    decision::conclude(match, config);
  }
}

/// Whether the object lies at another place as well, more likely than not.
bool is_likely_elsewhere(const Match& match) {
  return std::any_of(
      match.competitors.begin(), match.competitors.end(),
      [&](const Competitor& one) { return one.name == match.name && one.log_odds > 0; });
}

}  // namespace

struct Matcher::Implementation {
  SearchConfig config;
  ObjectList objects;
  std::map<std::string, std::string> unsearchable;  // reasons by name, of enabled objects
  mutable scene::ScenePool scenes;

  /// The object if it is already prepared; otherwise null.
  std::shared_ptr<const prepared::PreparedObject> known(const ObjectModel* object) const;

  /// Prepares the object unless it is already prepared. Throws if that fails.
  std::shared_ptr<const prepared::PreparedObject> prepare(
      const std::shared_ptr<const ObjectModel>& object, bool for_one_search) const;

  /// Reasons by name of the enabled objects that cannot be searched for in images of this size.
  std::map<std::string, std::string> unsearchable_in(cv::Size image) const;

  /// The requested objects that can be searched for in an image of this size; the reasons of the
  /// others go to `result.skipped`.
  ObjectList wanted(const SearchRequest& request, cv::Size image, SearchResult& result) const;

  /// Searches `image` for `wanted`, and again after removal of a colour cast estimated from the
  /// detections, unless the time budget ends that search: all detections are of one image, so that
  /// they can be compared.
  SearchState search(const ObjectList& wanted, const cv::Mat& image, bool grey,
                     const SearchRequest& request, Clock::time_point start) const;

  /// Per name.
  int most_instances(const SearchRequest& request) const {
    return request.max_instances > 0 ? request.max_instances : config.max_instances;
  }

  decision::AcceptanceSettings acceptance(const SearchRequest& request, std::size_t objects) const;
};

std::shared_ptr<const prepared::PreparedObject> Matcher::Implementation::known(
    const ObjectModel* object) const {
  const auto at = std::find_if(objects.begin(), objects.end(),
                               [&](const auto& other) { return other->model.get() == object; });
  return at == objects.end() ? nullptr : *at;
}

std::shared_ptr<const prepared::PreparedObject> Matcher::Implementation::prepare(
    const std::shared_ptr<const ObjectModel>& object, bool for_one_search) const {
  auto prepared = known(object.get());
  if (!prepared)
    prepared = std::make_shared<const prepared::PreparedObject>(object, prepared::engine_of(config),
                                                                config.scale_range);
  if (!for_one_search) prepared->make_rotations();
  return prepared;
}

std::map<std::string, std::string> Matcher::Implementation::unsearchable_in(cv::Size image) const {
  auto reasons = unsearchable;
  for (const auto& object : objects) {
    const int least = object->least_image();
    if (object->model->enabled && std::min(image.width, image.height) < least)
      reasons[object->model->name] =
          "the image is less than " + std::to_string(least) + " px wide or high";
  }
  return reasons;
}

ObjectList Matcher::Implementation::wanted(const SearchRequest& request, cv::Size image,
                                           SearchResult& result) const {
  const auto faults = unsearchable_in(image);
  std::vector<std::string> names = request.names;
  if (names.empty()) {
    for (const auto& [name, reason] : unsearchable) names.push_back(name);
    for (const auto& object : objects)
      if (object->model->enabled) names.push_back(object->model->name);
  }
  ObjectList chosen;
  for (const auto& name : names) {
    const auto at = std::find_if(objects.begin(), objects.end(),
                                 [&](const auto& object) { return object->model->name == name; });
    const auto fault = faults.find(name);
    if (fault != faults.end())
      result.skipped.push_back(name + ": " + fault->second);
    else if (at == objects.end())
      result.skipped.push_back(name + ": unknown");
    else if (!(*at)->model->enabled)
      result.skipped.push_back(name + ": disabled");
    else if (std::find(chosen.begin(), chosen.end(), *at) == chosen.end())
      chosen.push_back(*at);
  }
  return chosen;
}

SearchState Matcher::Implementation::search(const ObjectList& wanted, const cv::Mat& image,
                                            bool grey, const SearchRequest& request,
                                            Clock::time_point start) const {
  const search::SearchMode mode = mode_for(wanted.size(), request, config);
  const auto time_is_up = [&] {
    return config.time_budget > 0 && seconds_since(start) > config.time_budget;
  };
  const auto search_all = [&](const std::vector<prepared::Comparison>& compared) {
    SearchState findings(wanted.size());
    in_parallel(wanted.size(), config.threads, [&](std::size_t i) {
      const bool first = i == 0;  // otherwise a short budget would never find anything
      if (!first && time_is_up()) return;
      findings.found[i] =
          search::search_object(*compared[i].object, *compared[i].scene, request.part, mode);
      findings.searched[i] = 1;
    });
    compare_in_place(compared, request, findings);
    return findings;
  };
  const auto shown = prepared::comparisons(wanted, image, grey, scenes);
  SearchState findings = search_all(shown);
  if (mode != search::SearchMode::kColourPrefiltered || time_is_up()) return findings;
  const auto cast = search::colour_cast(shown, findings.found);
  if (!cast) return findings;
  SearchState balanced =
      search_all(prepared::comparisons(wanted, search::without_cast(image, *cast), grey, scenes));
  return balanced.complete() ? balanced : findings;
}

decision::AcceptanceSettings Matcher::Implementation::acceptance(const SearchRequest& request,
                                                                 std::size_t objects) const {
  return {config,
          request.min_score >= 0 ? std::make_optional(request.min_score) : std::nullopt,
          request.roi.empty() ? most_instances(request) : kUnlimited,
          request.clutter,
          request.elsewhere,
          std::max(objects, request.among),
          request.part};
}

std::vector<std::string> names_at_limit(const std::vector<Match>& matches, int most) {
  std::map<std::string, int> counts;
  std::vector<std::string> names;
  for (const auto& match : matches)
    if (++counts[match.name] == most && (most > 1 || is_likely_elsewhere(match)))
      names.push_back(match.name);
  return names;
}

std::string other_image_size(const ObjectModel& object, cv::Size size) {
  const cv::Size learned = object.views.front().image_size;
  if (learned == size) return "";
  return "learned in images of " + text(learned) + ", this one is " + text(size) +
         "; teach it again at this size";
}

Matcher::Matcher(SearchConfig config) : implementation_(std::make_unique<Implementation>()) {
  implementation_->config = std::move(config);
}
Matcher::~Matcher() = default;
Matcher::Matcher(Matcher&&) noexcept = default;
Matcher& Matcher::operator=(Matcher&&) noexcept = default;

const SearchConfig& Matcher::config() const {
  return implementation_->config;
}

void Matcher::set_objects(std::vector<std::shared_ptr<const ObjectModel>> objects,
                          bool for_one_search) {
  for (const auto& object : objects)
    if (!implementation_->known(object.get())) validate(*object);
  ObjectList prepared;
  std::map<std::string, std::string> unsearchable;
  for (const auto& object : objects) {
    try {
      prepared.push_back(implementation_->prepare(object, for_one_search));
    } catch (const std::exception& error) {
      if (object->enabled)
        unsearchable[object->name] =
            std::string("cannot be searched for: ") + error.what() + "; teach it again";
    }
  }
  implementation_->objects = std::move(prepared);
  implementation_->unsearchable = std::move(unsearchable);
}

const std::map<std::string, std::string>& Matcher::unsearchable() const {
  return implementation_->unsearchable;
}

std::map<std::string, std::string> Matcher::unsearchable_in(cv::Size image) const {
  return implementation_->unsearchable_in(image);
}

std::vector<std::shared_ptr<const ObjectModel>> Matcher::objects() const {
  std::vector<std::shared_ptr<const ObjectModel>> models;
  for (const auto& object : implementation_->objects) models.push_back(object->model);
  return models;
}

void Matcher::configure(SearchConfig config) {
  config.engine = implementation_->config.engine;
  config.scale_range = implementation_->config.scale_range;
  implementation_->config = std::move(config);
}

cv::Mat Matcher::score_map(const cv::Mat& image, const SearchRequest& request) const {
  SearchResult ignored;
  const ObjectList objects = implementation_->wanted(request, image.size(), ignored);
  const auto scene = implementation_->scenes.prepare(image, top_level(objects));
  cv::Mat best = cv::Mat::zeros(scene->size(), CV_32FC1);
  for (const auto& object : objects)
    for (const auto& view : object->views) {
      const int level = view.template_bank.level;
      if (!view.template_bank.searched() || level > scene->top_level()) continue;
      const cv::Mat coarse = proposal::coarse_similarity(
          view.template_bank, *scene->padded(level, view.template_bank.radius + 1),
          scene->grey[level].size());
      cv::Mat full;
      cv::resize(coarse, full, best.size(), 0, 0, cv::INTER_LINEAR);
      best = cv::max(best, full);
    }
  return best;
}

SearchResult Matcher::find(const cv::Mat& image, const SearchRequest& request) const {
  const auto start = Clock::now();
  scene::check_searchable(image);
  SearchResult result;
  const ObjectList objects = implementation_->wanted(request, image.size(), result);
  const bool grey = request.is_grey ? *request.is_grey : scene::is_grey(image);
  const SearchState findings = implementation_->search(objects, image, grey, request, start);
  note_searched(objects, findings, result);
  const auto acceptance = implementation_->acceptance(request, objects.size());
  decision::Selection selection = decision::select_matches(all_of(findings), acceptance);
  result.matches = std::move(selection.matches);
  doubt_without_comparison(objects, findings, implementation_->config, result.matches);
  const auto is_taught_in_colour = [&](const std::string& name) {
    return std::any_of(objects.begin(), objects.end(),
                       [&](const auto& one) { return one->model->name == name && one->coloured; });
  };
  decision::doubt_missing_colour(is_taught_in_colour, image, grey, implementation_->config,
                                 result.matches);
  const int most = implementation_->most_instances(request);
  result.matches =
      decision::reported(std::move(result.matches), request.roi, most, implementation_->config);
  result.limited = names_at_limit(result.matches, most);
  result.rivals = std::move(selection.rivals);
  result.clutter = std::move(selection.clutter);
  result.search_time = seconds_since(start);
  return result;
}

}  // namespace mbncc
