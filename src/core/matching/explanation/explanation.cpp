// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/explanation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "matching/evidence/evidence.hpp"
#include "matching/prepared/comparison.hpp"
#include "matching/scene/grey_image.hpp"
#include "matching/search/occupied_search.hpp"

namespace mbncc {
namespace {

using Outcome = Explanation::Outcome;
using Models = std::vector<std::shared_ptr<const ObjectModel>>;

constexpr int kAllInstances = 1000;

/// Whether the place lies inside the smallest circle around the outline.
bool lies_at(const std::vector<cv::Point2f>& outline, cv::Point2d place) {
  if (outline.size() < 3) return false;
  cv::Point2f centre;
  float radius = 0;
  cv::minEnclosingCircle(outline, centre, radius);
  return cv::norm(cv::Point2d(centre) - place) <= radius;
}

template <class Thing>
const Thing* best_at(const std::vector<Thing>& things, const std::string& name, cv::Point2d place) {
  const Thing* best = nullptr;
  for (const auto& thing : things)
    if (thing.name == name && lies_at(thing.outline, place) &&
        (best == nullptr || thing.log_odds() > best->log_odds()))
      best = &thing;
  return best;
}

/// Name of another object whose match overlaps the box of `outline`; "": none.
std::string covering(const std::vector<Match>& matches, const std::string& name,
                     const std::vector<cv::Point2f>& outline) {
  const cv::Rect box = cv::boundingRect(outline);
  for (const auto& match : matches) {
    const cv::Rect other = cv::boundingRect(match.outline);
    if (match.name != name && (box & other).area() * 4 > std::min(box.area(), other.area()))
      return match.name;
  }
  return "";
}

/// Appends the terms of the evidence for the view at `anchor`, `scale` times as large. Returns the
/// log-odds of the evidence.
double take_evidence(const prepared::PreparedView& view, const scene::SceneImage& scene,
                     const Pose2D& anchor, double scale, std::vector<ScorePart>& parts) {
  const evidence::Evidence seen =
      evidence::gather_evidence(view.fine, scene.levels[0], anchor, scale);
  const double area = view.shape.area(), together = evidence::log_odds(seen, area);
  const auto add = [&](const char* name, double value, double evidence::Evidence::*member,
                       double perfect) {
    evidence::Evidence better = seen;
    better.*member = perfect;
    parts.push_back({name, value, evidence::log_odds(better, area) - together});
  };
  // Residual of two images of one object that differ only by noise.
  const double kEqual = std::log(6.0);
  add("outline found", seen.contour_coverage, &evidence::Evidence::contour_coverage, 1);
  add("directions of texture", seen.gradient, &evidence::Evidence::gradient, 1);
  add("difference of colours [grey levels]", std::exp(seen.trimmed_residual) - 3,
      &evidence::Evidence::trimmed_residual, std::min(kEqual, seen.trimmed_residual));
  add("colours as a whole", seen.histogram, &evidence::Evidence::histogram, 1);
  add("colours without shading", seen.shading_free_ncc, &evidence::Evidence::shading_free_ncc, 1);
  add("part of the surface compared", seen.compared, &evidence::Evidence::compared, 1);
  add("cast of the light", seen.cast, &evidence::Evidence::cast, 0);
  return together;
}

/// The pose of the view's anchor if the object frame is at `pose` and the object `scale` times as
/// large as the view.
Pose2D anchor_of(const prepared::PreparedView& view, const Pose2D& pose, double scale) {
  const Pose2D& reference = view.reference_in_anchor;
  const double theta = pose.theta - reference.theta;
  const cv::Point2d lever = scale * rotate(reference.position(), theta);
  return {pose.x - lever.x, pose.y - lever.y, theta};
}

/// Sets the terms of the evidence for the view that fits the explained pose best.
void take_best_evidence(const prepared::PreparedObject& object, const scene::SceneImage& scene,
                        Explanation& explanation) {
  double best = -std::numeric_limits<double>::max();
  for (const auto& view : object.views) {
    if (view.polar) return;
    std::vector<ScorePart> parts;
    const double scale = explanation.scale / view.scale;
    const double evidence =
        take_evidence(view, scene, anchor_of(view, explanation.pose, scale), scale, parts);
    if (evidence <= best) continue;
    best = evidence;
    explanation.parts = parts;
  }
}

void take_match(const Match& match, const SearchConfig& config, double min_score,
                Explanation& explanation) {
  explanation.pose = match.pose;
  explanation.scale = match.scale;
  explanation.score = match.score;
  explanation.odds = match.odds;
  explanation.outline = match.outline;
  explanation.reasons = match.reasons;
  explanation.competitors = match.competitors;
  const auto check = [&](const char* name, double value, double threshold, bool to_report) {
    explanation.checks.push_back({name, value, threshold, value >= threshold, to_report});
  };
  check("min_score", match.score, min_score, true);
  check("confirm_score", match.score, config.confirm_score, false);
  check("min_margin_place", match.margin_place, config.min_margin_place, false);
  check("min_margin_angle", match.margin_angle, config.min_margin_angle, false);
  check("min_visible", match.visible, config.min_visible, false);
}

class Explainer {
 public:
  Explainer(const Models& objects, const SearchConfig& config, const cv::Mat& image,
            cv::Point2d place)
      : config_(config), place_(place) {
    SearchConfig unhurried = config;
    unhurried.time_budget = 0;
    Matcher matcher(unhurried);
    matcher.set_objects(objects, true);
    usual_ = matcher.find(image);
    SearchRequest all;
    all.min_score = 0;
    all.max_instances = kAllInstances;
    all_ = matcher.find(image, all);
    image_ = image;
  }

  /// Why the object was not searched for; "" if it was.
  std::string not_searched(const std::string& name) const {
    for (const auto& skipped : usual_.skipped)
      if (skipped.rfind(name + ": ", 0) == 0) return skipped;
    return "";
  }

  Explanation of(const std::shared_ptr<const ObjectModel>& model) {
    Explanation explanation;
    explanation.name = model->name;
    const double min_score = model->min_score.value_or(config_.min_score);
    const auto prepared = std::make_shared<const prepared::PreparedObject>(
        model, prepared::engine_of(config_), config_.scale_range);
    const auto [object, scene] =
        prepared::comparisons({prepared}, image_, scene::is_grey(image_), scenes_).front();
    if (const Match* match = best_at(usual_.matches, model->name, place_)) {
      explanation.outcome = match->graspable ? Outcome::kGraspable : Outcome::kReported;
      take_match(*match, config_, min_score, explanation);
    } else if (const Match* held_back = best_at(all_.matches, model->name, place_)) {
      explanation.outcome = Outcome::kRejected;
      take_match(*held_back, config_, min_score, explanation);
    } else if (const Rival* rival = best_at(usual_.rivals, model->name, place_)) {
      explanation.outcome = Outcome::kRejected;
      judge_at(*object, *scene, explanation);
      explanation.odds = rival->odds;
      explanation.score = rival->odds.score();
    } else {
      judge_at(*object, *scene, explanation);
    }
    if (explanation.outcome == Outcome::kRejected || explanation.outcome == Outcome::kNotProposed)
      explanation.covered_by = covering(usual_.matches, model->name, explanation.outline);
    if (!explanation.outline.empty()) take_best_evidence(*object, *scene, explanation);
    return explanation;
  }

 private:
  /// Sets pose and score to the best ones near the place, whether or not the search proposes them.
  void judge_at(const prepared::PreparedObject& object, const scene::SceneImage& scene,
                Explanation& explanation) const {
    const auto clutter = usual_.clutter.find(object.model->name);
    explanation.odds.best_at_place = -std::numeric_limits<double>::infinity();
    for (const auto& view : object.views) {
      if (view.polar) continue;
      for (const auto& one : search::search_places(object, view, scene, {place_})) {
        LogOdds odds = one.odds;
        odds.clutter = clutter == usual_.clutter.end() ? 0 : clutter->second;
        if (odds.total() <= explanation.odds.total()) continue;
        explanation.odds = odds;
        explanation.scale = view.scale * one.scale;
        explanation.pose = decision::object_pose(one);
        explanation.outline = decision::outline_at(one);
      }
    }
    explanation.score = explanation.odds.score();
  }

  SearchConfig config_;
  cv::Mat image_;
  cv::Point2d place_;
  SearchResult usual_, all_;  // of the whole image, as configured and without thresholds
  scene::ScenePool scenes_;
};

Models asked_for(const Models& objects, const std::vector<std::string>& names) {
  Models asked;
  for (const auto& name : names) {
    const auto at = std::find_if(objects.begin(), objects.end(),
                                 [&](const auto& object) { return object->name == name; });
    if (at == objects.end())
      throw std::invalid_argument("the library does not hold '" + name + "'");
    if (!(*at)->enabled)
      throw std::invalid_argument("'" + name +
                                  "' is disabled, so it is not searched for; enable it");
    asked.push_back(*at);
  }
  if (!names.empty()) return asked;
  std::copy_if(objects.begin(), objects.end(), std::back_inserter(asked),
               [](const auto& object) { return object->enabled; });
  return asked;
}

}  // namespace

std::vector<Explanation> explain_place(const Models& objects, const SearchConfig& config,
                                       const cv::Mat& image, cv::Point2d place,
                                       const std::vector<std::string>& names) {
  const Models asked = asked_for(objects, names);
  if (!(place.x >= 0 && place.y >= 0 && place.x < image.cols && place.y < image.rows))
    throw std::invalid_argument("the place does not lie in the image of " +
                                std::to_string(image.cols) + " x " + std::to_string(image.rows) +
                                " px");
  Explainer explainer(objects, config, image, place);
  std::vector<Explanation> explanations;
  for (const auto& object : asked) {
    const std::string fault = explainer.not_searched(object->name);
    if (fault.empty())
      explanations.push_back(explainer.of(object));
    else if (!names.empty())
      throw std::invalid_argument(fault);
  }
  std::stable_sort(
      explanations.begin(), explanations.end(),
      [](const Explanation& a, const Explanation& b) { return a.odds.total() > b.odds.total(); });
  return explanations;
}

}  // namespace mbncc
