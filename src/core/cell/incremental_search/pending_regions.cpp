// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/pending_regions.hpp"

#include <algorithm>

namespace mbncc::incremental_search {
namespace {

constexpr double kWaste = 1.3;  // largest area of a joined region relative to that of its parts

bool worth_joining(const cv::Rect& a, const cv::Rect& b) {
  return (a | b).area() <= kWaste * (a.area() + b.area() - (a & b).area());
}

}  // namespace

void PendingRegions::add(const std::string& name, const cv::Rect& region) {
  if (region.empty()) return;
  for (auto& one : pending_)
    if (one.name == name && worth_joining(one.region, region)) {
      one.region |= region;
      return;
    }
  pending_.push_back({name, region});
}

void PendingRegions::complete(const std::string& name, const cv::Rect& region) {
  pending_.erase(
      std::remove_if(pending_.begin(), pending_.end(),
                     [&](const Pending& one) { return one.name == name && one.region == region; }),
      pending_.end());
}

void PendingRegions::forget(const std::string& name) {
  pending_.erase(std::remove_if(pending_.begin(), pending_.end(),
                                [&](const Pending& one) { return one.name == name; }),
                 pending_.end());
}

std::vector<PendingRegions::Pending> PendingRegions::next(const Urgency& urgency, int least,
                                                          std::size_t most) const {
  const auto first = std::min_element(
      pending_.begin(), pending_.end(),
      [&](const Pending& a, const Pending& b) { return urgency(a.name) < urgency(b.name); });
  if (first == pending_.end() || urgency(first->name) > least) return {};
  std::vector<Pending> found{*first};
  cv::Rect place = first->region;
  for (const auto& one : pending_) {
    if (found.size() >= most) break;
    const bool known = std::any_of(found.begin(), found.end(),
                                   [&](const Pending& other) { return other.name == one.name; });
    if (known || urgency(one.name) > least || !worth_joining(place, one.region)) continue;
    place |= one.region;
    found.push_back(one);
  }
  return found;
}

bool PendingRegions::contains(const std::string& name) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [&](const Pending& one) { return one.name == name; });
}

bool PendingRegions::is_open(const cv::Rect& region) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [&](const Pending& one) { return !(one.region & region).empty(); });
}

}  // namespace mbncc::incremental_search
