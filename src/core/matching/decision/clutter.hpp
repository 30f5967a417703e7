// SPDX-License-Identifier: BSD-3-Clause
// How much the rest of the picture looks like the object.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "matching/decision/detection.hpp"

namespace mbncc {

/// Places that are asked how well the picture passes for the object, with the best one.
constexpr std::size_t kCluttered = 10;
/// Log-odds: what passes so well for the object is no mere like of it.
constexpr double kInstance = 8;
/// [radii] Nearer detections are of one place.
constexpr double kSamePlace = 0.7;

/// Log-odds that what looks alike elsewhere takes away, other instances apart. `odds` are those of
/// the best detections of up to kCluttered different places, best first.
double clutter_penalty(const std::vector<double>& odds);

/// Lowers the log-odds of every object's detections by what is found of it elsewhere: where several
/// places nearly pass for the object, the picture is full of its likes, and each of them is less
/// likely to be it. One place alone loses nothing, nor do several beyond doubt, and order and
/// margins stay as they are. `least`: log-odds by name that are taken off at least. `rarity`:
/// log-odds taken off all in addition, see multiple_testing_penalty(). Returns what was taken off.
std::map<std::string, double> apply_clutter_penalty(std::vector<Detection>& detections,
                                                    const std::map<std::string, double>& least = {},
                                                    double rarity = 0);

/// Log-odds that an object loses beforehand when `count` are looked for in one picture: chance has
/// as many tries, and few of the objects will be there.
double multiple_testing_penalty(std::size_t count);

}  // namespace mbncc
