// SPDX-License-Identifier: BSD-3-Clause
// Clutter: similarity of the rest of the image to the object.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "matching/decision/detection.hpp"

namespace mbncc::decision {

/// [radii] Nearer detections are of one place.
constexpr double kSamePlace = 0.7;

/// Lowers the log-odds of every object's detections by its clutter penalty: if several places
/// nearly match the object, each of them is less likely to be right. A single place or several
/// certain instances lose nothing; order and margins do not change. `least`: least penalty by name.
/// `rarity`: additional penalty of all, see multiple_testing_penalty(). Returns the penalties.
std::map<std::string, double> apply_clutter_penalty(std::vector<Detection>& detections,
                                                    const std::map<std::string, double>& least = {},
                                                    double rarity = 0);

/// Log-odds penalty of every object if `count` objects are searched in one image: more objects
/// mean more chance matches, and few of the objects are present.
double multiple_testing_penalty(std::size_t count);

}  // namespace mbncc::decision
