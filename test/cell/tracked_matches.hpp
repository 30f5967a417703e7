// SPDX-License-Identifier: BSD-3-Clause
// Matches for tests of the tracker.
#pragma once

#include <string>

#include "mbncc/cell/tracker.hpp"

namespace mbncc {

/// A graspable match whose outline has a radius of 40 px.
inline Match match_at(double x, double y, double theta = 0, const std::string& name = "key") {
  Match match;
  match.name = name;
  match.revision = 1;
  match.pose = {x, y, theta};
  match.graspable = true;
  for (const double angle : {0.0, 2.0, 4.0})
    match.outline.emplace_back(match.pose.position() + rotate({40, 0}, angle));
  return match;
}

inline Match ambiguous_at(double x, double y) {
  Match match = match_at(x, y);
  match.graspable = false;
  match.ambiguous = true;
  return match;
}

}  // namespace mbncc
