// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/object_schedule.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace mbncc::incremental_search {
namespace {

constexpr double kLeastReach = 16;   // [px] least reach
constexpr double kReachShare = 0.5;  // reach as a part of the object's radius
// A change may show a part of the object only: the distance of its excircle's centre from the
// change, as a part of the excircle's radius.
constexpr double kOverhang = 0.35;

SearchedObject searched(std::shared_ptr<const ObjectModel> model) {
  SearchedObject object;
  for (const auto& view : model->views) {
    std::vector<cv::Point2f> points;
    for (const auto& outline : outlines(view))
      points.insert(points.end(), outline.begin(), outline.end());
    for (const auto& point : points) object.radius = std::max(object.radius, cv::norm(point));
    cv::Point2f centre;
    float excircle = 0;
    cv::minEnclosingCircle(points, centre, excircle);
    object.overhang = std::max(object.overhang, cv::norm(centre) + kOverhang * excircle);
  }
  object.model = std::move(model);
  return object;
}

}  // namespace

double SearchedObject::reach() const {
  return std::max(kLeastReach, kReachShare * radius);
}

std::vector<std::string> ObjectSchedule::update(
    std::vector<std::shared_ptr<const ObjectModel>> models,
    std::map<std::string, std::string> unsearchable) {
  if (models == models_ && unsearchable == unsearchable_) return {};
  unsearchable_ = std::move(unsearchable);
  models_ = std::move(models);
  std::map<std::string, SearchedObject> before = std::exchange(objects_, {});
  for (const auto& model : models_) {
    if (!model->enabled || !is_requested(model->name) || unsearchable_.count(model->name) > 0)
      continue;
    const auto known = before.find(model->name);
    if (known != before.end() && known->second.model == model)
      objects_.insert(before.extract(known));
    else
      objects_[model->name] = searched(model);
  }
  std::vector<std::string> gone;
  for (const auto& [name, object] : before) gone.push_back(name);
  return gone;
}

bool ObjectSchedule::is_requested(const std::string& name) const {
  return requested_.empty() ||
         std::find(requested_.begin(), requested_.end(), name) != requested_.end();
}

std::vector<std::string> ObjectSchedule::names() const {
  std::vector<std::string> names;
  for (const auto& [name, object] : objects_) names.push_back(name);
  return names;
}

double ObjectSchedule::largest_radius() const {
  return radius(names());
}

double ObjectSchedule::radius(const std::vector<std::string>& names) const {
  double radius = 0;
  for (const auto& name : names) radius = std::max(radius, at(name).radius);
  return radius;
}

std::string ObjectSchedule::longest_unswept() const {
  return std::min_element(
             objects_.begin(), objects_.end(),
             [](const auto& a, const auto& b) { return a.second.swept_at < b.second.swept_at; })
      ->first;
}

std::optional<std::string> ObjectSchedule::most_urgent() const {
  std::optional<std::string> most;
  for (const auto& [name, object] : objects_)
    if (object.urgent && (!most || object.swept_at < at(*most).swept_at)) most = name;
  return most;
}

std::vector<std::string> ObjectSchedule::unavailable() const {
  std::vector<std::string> reasons;
  for (const auto& [name, reason] : unsearchable_)
    if (is_requested(name)) reasons.push_back(name + ": " + reason);
  for (const auto& name : requested_)
    if (objects_.count(name) == 0 && unsearchable_.count(name) == 0)
      reasons.push_back(name + ": unknown or disabled");
  return reasons;
}

}  // namespace mbncc::incremental_search
