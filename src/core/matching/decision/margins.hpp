// SPDX-License-Identifier: BSD-3-Clause
// Margins of detections to their competitors.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "matching/decision/detection.hpp"

namespace mbncc::decision {

/// [log-odds] Margin if there is no competitor; also the largest margin.
constexpr double kNoCompetitor = 20;

/// [rad] Poses of one place whose angles differ by more, modulo the symmetry, compete as rotations.
constexpr double kOtherAngle = to_radians(10);

/// Log-odds of `other` as a competitor of `detection`, see LogOdds::of_competitor().
double log_odds_against(const Detection& detection, const Detection& other);

/// The best other rotation of the same object at the detection's place; null: none.
const Detection* competing_angle(const Detection& detection, const std::vector<Detection>& all);

/// Margin to a competing rotation, negative if that is better; kNoCompetitor if null.
double margin_to(const Detection& detection, const Detection* other);

/// Margin to the best other place of the same object, including accepted instances. `elsewhere`:
/// see SearchRequest.
double instance_margin(const Detection& detection, const std::vector<Detection>& all,
                       const std::map<std::string, double>& elsewhere);

/// The best other place of the same object that does not belong to an accepted instance, as it does
/// by more than `max_overlap`; null: none.
const Detection* competing_place(const Detection& detection, const std::vector<Detection>& all,
                                 const std::vector<const Detection*>& accepted, double max_overlap);

/// Added to the covariance [px],[rad] of the object's pose because another pose of the same object
/// at the same angle, 3 px or more beside it, may be the true one, as one pitch along a periodic
/// part whose end is hidden: the square of the displacement, times the probability of that pose
/// against this one. The largest one; zero without such a pose.
cv::Matx33d displacement_covariance(const Detection& detection, const std::vector<Detection>& all);

/// The best detection of another object at the detection's place; null: none.
const Detection* competing_object(const Detection& detection, const std::vector<Detection>& all);

}  // namespace mbncc::decision
