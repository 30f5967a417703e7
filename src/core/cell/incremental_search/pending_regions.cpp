// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/pending_regions.hpp"

#include <algorithm>

namespace mbncc {
namespace {

constexpr double kWaste = 1.3;  // area of a joint region by that of its parts

bool worth_joining(const cv::Rect& a, const cv::Rect& b) {
  return (a | b).area() <= kWaste * (a.area() + b.area() - (a & b).area());
}

}  // namespace

void PendingRegions::owe(const std::string& name, const cv::Rect& region) {
  if (region.empty()) return;
  for (auto& debt : debts_)
    if (debt.name == name && worth_joining(debt.region, region)) {
      debt.region |= region;
      return;
    }
  debts_.push_back({name, region});
}

void PendingRegions::pay(const std::string& name, const cv::Rect& region) {
  debts_.erase(
      std::remove_if(debts_.begin(), debts_.end(),
                     [&](const Debt& debt) { return debt.name == name && debt.region == region; }),
      debts_.end());
}

void PendingRegions::forget(const std::string& name) {
  debts_.erase(std::remove_if(debts_.begin(), debts_.end(),
                              [&](const Debt& debt) { return debt.name == name; }),
               debts_.end());
}

std::optional<PendingRegions::Debt> PendingRegions::next(const Urgency& urgency) const {
  if (debts_.empty()) return std::nullopt;
  return *std::min_element(debts_.begin(), debts_.end(), [&](const Debt& a, const Debt& b) {
    return urgency(a.name) < urgency(b.name);
  });
}

bool PendingRegions::owes(const std::string& name) const {
  return std::any_of(debts_.begin(), debts_.end(),
                     [&](const Debt& debt) { return debt.name == name; });
}

bool PendingRegions::is_open(const cv::Rect& region) const {
  return std::any_of(debts_.begin(), debts_.end(),
                     [&](const Debt& debt) { return !(debt.region & region).empty(); });
}

}  // namespace mbncc
