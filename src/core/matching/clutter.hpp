// How much the rest of the picture looks like the object.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "matching/detection.hpp"

namespace mbncc {

/// Lowers the log-odds of every object's detections by what is found of it elsewhere: where several
/// places nearly pass for the object, the picture is full of its likes, and each of them is less
/// likely to be it. One place alone loses nothing, and order and margins stay as they are. `least`:
/// log-odds by name that are taken off at least. Returns what was taken off.
std::map<std::string, double> discount_clutter(std::vector<Detection>& detections,
                                               const std::map<std::string, double>& least = {});

}  // namespace mbncc
