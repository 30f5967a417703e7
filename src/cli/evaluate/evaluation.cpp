// SPDX-License-Identifier: BSD-3-Clause
#include "cli/evaluate/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mbncc::cli {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double share(int part, int whole) {
  return whole == 0 ? kNone : static_cast<double>(part) / whole;
}

}  // namespace

Comparison compare(const std::vector<TrueInstance>& truth, const std::vector<Match>& matches,
                   const Tolerance& tolerance) {
  Comparison result;
  std::vector<TrueInstance> open = truth;
  for (const auto& match : matches) {
    const auto place = [&](const TrueInstance& one) {
      return cv::norm(one.pose.position() - match.pose.position());
    };
    const auto angle = [&](const TrueInstance& one) {
      return angle_distance(one.pose.theta, match.pose.theta, match.symmetry);
    };
    auto best = open.end();
    for (auto one = open.begin(); one != open.end(); ++one)
      if ((one->name.empty() || one->name == match.name) && place(*one) <= tolerance.place &&
          angle(*one) <= tolerance.angle && (best == open.end() || place(*one) < place(*best)))
        best = one;
    if (best == open.end()) {
      result.wrong.push_back(match);
      continue;
    }
    result.right.push_back(match);
    result.place_errors.push_back(place(*best));
    result.angle_errors.push_back(angle(*best));
    open.erase(best);
  }
  result.missed = open;
  return result;
}

void Figures::add(const Comparison& comparison, double search_time) {
  const auto graspable = [](const std::vector<Match>& matches) {
    return static_cast<int>(std::count_if(matches.begin(), matches.end(),
                                          [](const Match& match) { return match.graspable; }));
  };
  ++images;
  instances += static_cast<int>(comparison.right.size() + comparison.missed.size());
  right += static_cast<int>(comparison.right.size());
  wrong += static_cast<int>(comparison.wrong.size());
  right_graspable += graspable(comparison.right);
  wrong_graspable += graspable(comparison.wrong);
  place_errors.insert(place_errors.end(), comparison.place_errors.begin(),
                      comparison.place_errors.end());
  angle_errors.insert(angle_errors.end(), comparison.angle_errors.begin(),
                      comparison.angle_errors.end());
  seconds += search_time;
}

double Figures::recall() const {
  return share(right, instances);
}
double Figures::recall_graspable() const {
  return share(right_graspable, instances);
}
double Figures::precision() const {
  return share(right, right + wrong);
}
double Figures::precision_graspable() const {
  return share(right_graspable, right_graspable + wrong_graspable);
}

double quantile(std::vector<double> values, double part) {
  if (values.empty()) return kNone;
  std::sort(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(std::lround(part * double(values.size() - 1)));
  return values[at];
}

}  // namespace mbncc::cli
