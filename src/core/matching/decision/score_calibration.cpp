// SPDX-License-Identifier: BSD-3-Clause
#include "matching/decision/score_calibration.hpp"

#include <algorithm>

namespace mbncc::decision {

double calibration(const Detection& detection, double angle_margin, double instance_margin) {
  constexpr double kUsual = 0.42;
  constexpr double kPerAgreement = 11.7, kFirm = -0.15, kLoose = 0.08;
  constexpr double kPerAngle = 0.4, kFarBehind = 8;      // log-odds
  constexpr double kPerInstance = 0.3, kMuchBetter = 5;  // log-odds
  constexpr double kPerContinued = 40, kAlone = 0.2, kLarger = 0.5;
  return kUsual - kPerAgreement * std::clamp(detection.contour_alternative, kFirm, kLoose) -
         kPerAngle * std::max(0.0, kFarBehind - angle_margin) -
         kPerInstance * std::max(0.0, -instance_margin - kMuchBetter) -
         kPerContinued * (std::clamp(detection.continued, kAlone, kLarger) - kAlone);
}

}  // namespace mbncc::decision
