// How much the rest of the picture looks like the object.
#pragma once

#include <vector>

#include "matching/detection.hpp"

namespace mbncc {

/// Lowers the log-odds of every object's detections by what is found of it elsewhere: where several
/// places nearly pass for the object, the picture is full of its likes, and each of them is less
/// likely to be it. One place alone loses nothing, and order and margins stay as they are.
void discount_clutter(std::vector<Detection>& detections);

}  // namespace mbncc
