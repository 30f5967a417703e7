#include "matching/clutter.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

// Fitted together with the weights of log_odds().
constexpr std::size_t kPlaces = kCluttered - 1;  // next best ones that tell about the picture
constexpr double kWeight = 0.85;
constexpr double kNothing = -6, kObvious = 5;  // log-odds: bounds of what a place says

bool same_place(const Detection& a, const Detection& b) {
  return cv::norm(a.pose.position() - b.pose.position()) <
         kSamePlace * std::min(a.view->shape.radius(), b.view->shape.radius());
}

/// Log-odds of the best detections of different places, best first.
std::vector<double> odds_of_places(std::vector<const Detection*> detections, std::size_t most) {
  std::stable_sort(
      detections.begin(), detections.end(),
      [](const Detection* a, const Detection* b) { return a->log_odds > b->log_odds; });
  std::vector<const Detection*> places;
  for (const Detection* detection : detections) {
    const bool known = std::any_of(places.begin(), places.end(), [&](const Detection* other) {
      return same_place(*detection, *other);
    });
    if (!known) places.push_back(detection);
    if (places.size() == most) break;
  }
  std::vector<double> odds;
  for (const Detection* place : places) odds.push_back(place->log_odds);
  return odds;
}

}  // namespace

double clutter_discount(std::vector<double> odds) {
  odds.resize(kPlaces + 1, kNothing);
  double sum = 0;
  for (std::size_t k = 1; k <= kPlaces; ++k)
    sum += std::clamp(odds[k], kNothing, kObvious) - kNothing;
  return kWeight * sum / kPlaces;
}

std::map<std::string, double> discount_clutter(std::vector<Detection>& detections,
                                               const std::map<std::string, double>& least,
                                               double rarity) {
  std::map<std::string, std::vector<const Detection*>> of_object;
  for (const auto& detection : detections)
    of_object[detection.object->model->name].push_back(&detection);
  std::map<std::string, double> discounts = least;
  for (const auto& [name, own] : of_object)
    discounts[name] =
        std::max(discounts[name], rarity + clutter_discount(odds_of_places(own, kCluttered)));
  for (auto& detection : detections) detection.log_odds -= discounts[detection.object->model->name];
  return discounts;
}

double rarity_among(std::size_t count) {
  return std::log(std::max(1.0, static_cast<double>(count) / kFewObjects));
}

}  // namespace mbncc
