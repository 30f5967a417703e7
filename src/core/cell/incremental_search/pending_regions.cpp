// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/pending_regions.hpp"

#include <algorithm>

namespace mbncc::incremental_search {
namespace {

constexpr double kWaste = 1.3;  // largest area of a joined region relative to that of its parts

double area(const cv::Rect& rect) {
  return cv::Rect2d(rect).area();  // reference points may lie far from an object
}

bool worth_joining(const cv::Rect& a, const cv::Rect& b) {
  return area(a | b) <= kWaste * (area(a) + area(b) - area(a & b));
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

std::optional<PendingRegions::Pending> PendingRegions::next(const Urgency& urgency) const {
  if (pending_.empty()) return std::nullopt;
  return *std::min_element(
      pending_.begin(), pending_.end(),
      [&](const Pending& a, const Pending& b) { return urgency(a.name) < urgency(b.name); });
}

bool PendingRegions::contains(const std::string& name) const {
  return std::any_of(pending_.begin(), pending_.end(),
                     [&](const Pending& one) { return one.name == name; });
}

}  // namespace mbncc::incremental_search
