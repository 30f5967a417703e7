// SPDX-License-Identifier: BSD-3-Clause
// Clutter: places elsewhere in the image that resemble the object.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "matching/decision/detection.hpp"

namespace mbncc::decision {

/// [radii] Detections closer than this are at the same place.
constexpr double kSamePlace = 0.7;

/// Lowers the log-odds of every object's detections by its clutter penalty: if several places
/// nearly match the object, each of them is less likely to be right. Single places and several
/// certain instances are not penalised. The order and margins of one object's detections do not
/// change. `least`: least penalty by name. `additional_penalty`: additional penalty of all objects,
/// see multiple_testing_penalty(). Returns the penalties by name.
std::map<std::string, double> apply_clutter_penalty(std::vector<Detection>& detections,
                                                    const std::map<std::string, double>& least = {},
                                                    double additional_penalty = 0);

/// Log-odds penalty of every object if `count` objects are searched in one image, because more
/// objects mean more chance matches and few of them are present.
double multiple_testing_penalty(std::size_t count);

}  // namespace mbncc::decision
