// SPDX-License-Identifier: BSD-3-Clause
// A matcher with one or several objects, and the expected match.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "matching/images.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::test {

inline constexpr double kPlaceTolerance = 0.5;              // [px]
inline constexpr double kAngleTolerance = to_radians(0.5);  // [rad]

class MatcherTest : public ::testing::Test {
 protected:
  const LearningImage source_{1};
  const Pose2D reference_{58, 60, 0};

  Matcher matcher_of(std::vector<std::shared_ptr<const ObjectModel>> objects,
                     const SearchConfig& config = {}) const {
    Matcher matcher(config);
    matcher.set_objects(std::move(objects));
    return matcher;
  }

  Matcher matcher() const { return matcher_of({object_from(source_, reference_)}); }

  static void expect_at(const Match& match, const Pose2D& truth) {
    EXPECT_NEAR(match.pose.x, truth.x, kPlaceTolerance);
    EXPECT_NEAR(match.pose.y, truth.y, kPlaceTolerance);
    EXPECT_LT(angle_distance(match.pose.theta, truth.theta), kAngleTolerance);
  }
};

}  // namespace mbncc::test
