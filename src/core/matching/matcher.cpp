#include "mbncc/matching/matcher.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <future>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "matching/clutter.hpp"
#include "matching/coarse_search.hpp"
#include "matching/colour_cast.hpp"
#include "matching/effort.hpp"
#include "matching/prepared_object.hpp"
#include "matching/scene_pool.hpp"
#include "matching/selection.hpp"
#include "matching/view_search.hpp"

namespace mbncc {
namespace {

using Clock = std::chrono::steady_clock;
using ObjectList = std::vector<std::shared_ptr<const PreparedObject>>;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Where the anchor of a view can be when its reference point lies in `roi`.
cv::Rect anchor_region(const cv::Rect& roi, const PreparedView& view, cv::Size size) {
  const cv::Rect picture({0, 0}, size);
  if (roi.empty()) return picture;
  const int lever = static_cast<int>(std::ceil(cv::norm(view.reference_in_anchor.position())));
  return cv::Rect(roi.x - lever, roi.y - lever, roi.width + 2 * lever, roi.height + 2 * lever) &
         picture;
}

bool reference_within(const Detection& detection, const cv::Rect& roi) {
  if (roi.empty()) return true;
  const Pose2D pose = compose(detection.pose, detection.view->reference_in_anchor);
  return pose.x >= roi.x && pose.y >= roi.y && pose.x <= roi.br().x - 1 && pose.y <= roi.br().y - 1;
}

std::vector<Detection> search_views(const PreparedObject& object, const ScenePicture& scene,
                                    const cv::Rect& roi, Look look) {
  const bool gated = look == Look::kGated;
  std::vector<Detection> found;
  for (const auto& view : object.views) {
    const auto detections = search_view(object, view, scene, anchor_region(roi, view, scene.size()),
                                        look, gated ? view.gate.places(scene.classes()) : Places{});
    std::copy_if(detections.begin(), detections.end(), std::back_inserter(found),
                 [&](const Detection& detection) { return reference_within(detection, roi); });
  }
  return object.views.size() > 1 ? compare_rotations(std::move(found)) : found;
}

/// Where the best of what was found lies, and a little about it; empty when nothing is likely.
cv::Rect place_of_best(const std::vector<Detection>& found) {
  const auto best = std::max_element(
      found.begin(), found.end(),
      [](const Detection& a, const Detection& b) { return a.log_odds < b.log_odds; });
  if (best == found.end() || best->log_odds < kFound) return {};
  const Pose2D pose = compose(best->pose, best->view->reference_in_anchor);
  const int reach = std::max(4, cvRound(0.25 * best->view->shape.radius()));
  return {cvRound(pose.x) - reach, cvRound(pose.y) - reach, 2 * reach + 1, 2 * reach + 1};
}

/// One look at the picture, a quick one more where the object was found: the sparing look may have
/// passed over the right angle there, or a rival of it.
std::vector<Detection> search_sparingly(const PreparedObject& object, const ScenePicture& scene,
                                        const cv::Rect& roi, Look look) {
  auto found = search_views(object, scene, roi, look);
  const cv::Rect place =
      place_of_best(found) & (roi.empty() ? cv::Rect({0, 0}, scene.size()) : roi);
  if (place.empty()) return found;
  const auto again = search_views(object, scene, place, Look::kQuick);
  found.insert(found.end(), again.begin(), again.end());
  return compare_rotations(std::move(found));
}

/// An instance fits one of several views best: a thorough look is worth it only when none finds it.
std::vector<Detection> search_object(const PreparedObject& object, const ScenePicture& scene,
                                     const cv::Rect& roi, Look look) {
  if (is_sparing(look)) return search_sparingly(object, scene, roi, look);
  if (object.views.size() == 1) return search_views(object, scene, roi, look);
  const auto found = search_views(object, scene, roi, Look::kQuick);
  const bool enough = std::any_of(found.begin(), found.end(), [](const Detection& detection) {
    return detection.log_odds >= kFound;
  });
  return enough ? found : search_views(object, scene, roi, look);
}

/// Calls work(i) for i in [0, count) on up to `threads` threads; what one throws reaches the
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

}  // namespace

struct Matcher::Implementation {
  SearchConfig config;
  ObjectList objects;
  mutable ScenePool scenes;

  /// The objects a request asks for; the others' reasons go to `result.skipped`.
  ObjectList wanted(const SearchRequest& request, SearchResult& result) const;
};

ObjectList Matcher::Implementation::wanted(const SearchRequest& request,
                                           SearchResult& result) const {
  ObjectList chosen;
  if (request.names.empty()) {
    std::copy_if(objects.begin(), objects.end(), std::back_inserter(chosen),
                 [](const auto& object) { return object->model->enabled; });
    return chosen;
  }
  for (const auto& name : request.names) {
    const auto at = std::find_if(objects.begin(), objects.end(),
                                 [&](const auto& object) { return object->model->name == name; });
    if (at == objects.end())
      result.skipped.push_back(name + ": unknown");
    else if (!(*at)->model->enabled)
      result.skipped.push_back(name + ": disabled");
    else if (std::find(chosen.begin(), chosen.end(), *at) == chosen.end())
      chosen.push_back(*at);
  }
  return chosen;
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
  const Engine engine = implementation_->config.engine == "polar" ? Engine::kPolar : Engine::kFast;
  ObjectList prepared;
  for (auto& object : objects) {
    const auto& old = implementation_->objects;
    const auto known = std::find_if(old.begin(), old.end(),
                                    [&](const auto& other) { return other->model == object; });
    prepared.push_back(known != old.end()
                           ? *known
                           : std::make_shared<const PreparedObject>(
                                 object, engine, implementation_->config.scale_range));
    if (!for_one_search) prepared.back()->make_rotations();
  }
  implementation_->objects = std::move(prepared);
}

std::vector<std::shared_ptr<const ObjectModel>> Matcher::objects() const {
  std::vector<std::shared_ptr<const ObjectModel>> models;
  for (const auto& object : implementation_->objects) models.push_back(object->model);
  return models;
}

void Matcher::set_limits(double min_score, int max_instances) {
  implementation_->config.min_score = min_score;
  implementation_->config.max_instances = max_instances;
}

cv::Mat Matcher::score_map(const cv::Mat& picture, const SearchRequest& request) const {
  SearchResult ignored;
  const ObjectList objects = implementation_->wanted(request, ignored);
  const auto scene = implementation_->scenes.show(picture, top_level(objects));
  cv::Mat best = cv::Mat::zeros(scene->size(), CV_32FC1);
  for (const auto& object : objects)
    for (const auto& view : object->views) {
      if (view.kernels.kernels->empty() || view.kernels.level == 0) continue;
      const cv::Mat coarse = coarse_similarity(view.kernels, scene->grey[view.kernels.level]);
      cv::Mat full;
      cv::resize(coarse, full, best.size(), 0, 0, cv::INTER_LINEAR);
      best = cv::max(best, full);
    }
  return best;
}

SearchResult Matcher::find(const cv::Mat& picture, const SearchRequest& request) const {
  const auto start = Clock::now();
  const SearchConfig& config = implementation_->config;
  SearchResult result;
  const ObjectList objects = implementation_->wanted(request, result);
  const bool many = objects.size() > kFewObjects && config.engine != "polar";
  ScenePool& scenes = implementation_->scenes;
  const auto scene = scenes.show(picture, top_level(objects));

  const bool thorough = objects.size() <= kFewObjects && !request.sparing;
  const Look look = many ? Look::kGated : thorough ? Look::kTwice : Look::kSparing;
  std::vector<std::vector<Detection>> found(objects.size());
  std::vector<char> searched(objects.size(), 0);
  const auto search_all = [&](const ScenePicture& seen) {
    in_parallel(objects.size(), config.threads, [&](std::size_t i) {
      const bool first = i == 0;  // without it, a short budget would find nothing for ever
      if (!first && config.time_budget > 0 && seconds_since(start) > config.time_budget) return;
      found[i] = search_object(*objects[i], seen, request.roi, look);
      searched[i] = 1;
    });
  };
  search_all(*scene);
  if (many && picture.type() == CV_8UC3)
    if (const auto cast = colour_cast(found, *scene))
      search_all(*scenes.show(without_cast(picture, *cast), top_level(objects)));

  std::vector<Detection> detections;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string& name = objects[i]->model->name;
    if (searched[i])
      result.searched.push_back(name);
    else
      result.skipped.push_back(name + ": time budget exceeded");
    detections.insert(detections.end(), found[i].begin(), found[i].end());
  }
  result.budget_exceeded = result.searched.size() < objects.size();
  Selection selection = select_matches(
      std::move(detections),
      {config, request.min_score >= 0 ? std::make_optional(request.min_score) : std::nullopt,
       request.max_instances > 0 ? request.max_instances : config.max_instances, request.clutter,
       rarity_among(objects.size())});
  result.matches = std::move(selection.matches);
  result.rivals = std::move(selection.rivals);
  result.clutter = std::move(selection.clutter);
  result.search_time = seconds_since(start);
  return result;
}

}  // namespace mbncc
