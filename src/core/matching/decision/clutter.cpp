// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/clutter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "matching/decision/clutter_penalty.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::decision {
namespace {

bool anchors_are_near(const Detection& a, const Detection& b) {
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
      return anchors_are_near(*detection, *other);
    });
    if (!known) places.push_back(detection);
  }
  std::vector<double> odds;
  for (const Detection* place : places) odds.push_back(place->log_odds());
  return odds;
}

}  // namespace

std::map<std::string, double> apply_clutter_penalty(std::vector<Detection>& detections,
                                                    const std::map<std::string, double>& least,
                                                    double additional_penalty) {
  std::map<std::string, std::vector<const Detection*>> of_object;
  for (const auto& detection : detections) of_object[detection.object->name].push_back(&detection);
  std::map<std::string, double> penalties = least;
  for (const auto& [name, own] : of_object)
    penalties[name] =
        std::max(penalties[name], additional_penalty + clutter_penalty(odds_of_places(own)));
  for (auto& detection : detections) detection.odds.clutter = penalties[detection.object->name];
  return penalties;
}

double multiple_testing_penalty(std::size_t count) {
  return std::log(std::max(1.0, static_cast<double>(count) / kFewObjects));
}

}  // namespace mbncc::decision
