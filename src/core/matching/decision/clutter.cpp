// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/clutter.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>

#include "mbncc/matching/match.hpp"

namespace mbncc::decision {
namespace {

// Fitted together with the weights of the evidence model.
constexpr std::size_t kPlaces = 3;  // number of places used
constexpr double kWeight = 0.85;
constexpr double kNothing = -6, kObvious = 5;  // log-odds: bounds of a place's contribution
constexpr double kInstance = 8;  // log-odds from which on a place is an instance, not clutter

bool same_place(const Detection& a, const Detection& b) {
  return cv::norm(a.pose.position() - b.pose.position()) <
         kSamePlace * std::min(a.view->shape.radius(), b.view->shape.radius());
}

/// Log-odds of the best detections of different places, best first.
std::vector<double> odds_of_places(std::vector<const Detection*> detections) {
  std::stable_sort(
      detections.begin(), detections.end(),
      [](const Detection* a, const Detection* b) { return a->log_odds() > b->log_odds(); });
  std::vector<const Detection*> places;
  for (const Detection* detection : detections) {
    const bool known = std::any_of(places.begin(), places.end(), [&](const Detection* other) {
      return same_place(*detection, *other);
    });
    if (!known) places.push_back(detection);
  }
  std::vector<double> odds;
  for (const Detection* place : places) odds.push_back(place->log_odds());
  return odds;
}

/// Contribution of a place of log-odds `odds` to the clutter; less if it is probably another
/// instance.
double clutter_weight(double odds) {
  const double uncertainty = std::clamp((kInstance - odds) / (kInstance - kObvious), 0., 1.);
  return uncertainty * (std::clamp(odds, kNothing, kObvious) - kNothing);
}

}  // namespace

double clutter_penalty(const std::vector<double>& odds) {
  if (odds.empty()) return 0;
  std::vector<double> likes;
  std::transform(odds.begin() + 1, odds.end(), std::back_inserter(likes), clutter_weight);
  std::sort(likes.begin(), likes.end(), std::greater<>());
  likes.resize(kPlaces, 0);
  return kWeight * std::accumulate(likes.begin(), likes.end(), 0.) / kPlaces;
}

std::map<std::string, double> apply_clutter_penalty(std::vector<Detection>& detections,
                                                    const std::map<std::string, double>& least,
                                                    double rarity) {
  std::map<std::string, std::vector<const Detection*>> of_object;
  for (const auto& detection : detections) of_object[detection.object->name].push_back(&detection);
  std::map<std::string, double> discounts = least;
  for (const auto& [name, own] : of_object)
    discounts[name] = std::max(discounts[name], rarity + clutter_penalty(odds_of_places(own)));
  for (auto& detection : detections) detection.odds.clutter = discounts[detection.object->name];
  return discounts;
}

double multiple_testing_penalty(std::size_t count) {
  return std::log(std::max(1.0, static_cast<double>(count) / kFewObjects));
}

}  // namespace mbncc::decision
