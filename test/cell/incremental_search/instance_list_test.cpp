// SPDX-License-Identifier: BSD-3-Clause
// Comparisons and competitors of an instance in a video.
#include "cell/incremental_search/instance_list.hpp"

#include <gtest/gtest.h>

namespace mbncc::incremental_search {
namespace {

constexpr double kReach = 10;  // [px]

/// A reliable instance whose outline is a square of 40 px.
Instance instance_at(double x, const std::string& name = "one", double log_odds = 20) {
  Instance instance;
  instance.match.name = name;
  instance.match.pose = {x, 100, 0};
  instance.match.odds.best_at_place = log_odds;
  instance.match.score = 0.9;
  instance.match.margin_angle = 20;
  for (const cv::Point2d corner : {cv::Point2d(-20, -20), {20, -20}, {20, 20}, {-20, 20}})
    instance.match.outline.emplace_back(instance.match.pose.position() + corner);
  instance.compared_elsewhere = true;
  return instance;
}

Rival rival_at(double x, const std::string& name, double log_odds) {
  return rival_of(instance_at(x, name, log_odds).match);
}

Match judged(const Instance& instance) {
  return instance.judged({"one", "other"}, SearchConfig());
}

TEST(Instance, IsGraspableAfterComparisonWithAllObjectsAndPlaces) {
  Instance instance = instance_at(100);
  instance.others["other"] = std::nullopt;
  EXPECT_TRUE(judged(instance).graspable);
  EXPECT_GE(judged(instance).margin_place, 20);
  Instance open = instance;
  open.others.clear();
  EXPECT_FALSE(judged(open).graspable) << "another object may lie there";
  EXPECT_LE(judged(open).margin_place, 0);
  EXPECT_FALSE(judged(open).reasons.empty());
  Instance here_alone = instance;
  here_alone.compared_elsewhere = false;
  EXPECT_FALSE(judged(here_alone).graspable) << "it may lie elsewhere";
  EXPECT_LE(judged(here_alone).margin_place, 0);
}

TEST(Instance, CompetitorsCountWhereverTheyAre) {
  Instance instance = instance_at(100);
  instance.others["other"] = Competitor{"other", {100, 100}, 18};
  EXPECT_NEAR(judged(instance).margin_place, 2, 1e-9);
  EXPECT_TRUE(judged(instance).ambiguous);
  EXPECT_FALSE(judged(instance).graspable);
  instance.others["other"] = std::nullopt;
  instance.elsewhere = Competitor{"one", {300, 100}, 17};
  EXPECT_NEAR(judged(instance).margin_place, 3, 1e-9);
  EXPECT_FALSE(judged(instance).graspable);
}

TEST(Instance, KeepsItsMarginsWhenTheSamePixelsAreSearchedAgain) {
  Instance before = instance_at(100), again = instance_at(100, "one", 25);
  before.others["other"] = Competitor{"other", {100, 100}, 18};
  before.elsewhere = Competitor{"one", {300, 100}, 17};
  again.inherit_comparisons(before);
  EXPECT_TRUE(again.compared_elsewhere);
  EXPECT_NEAR(judged(again).margin_place, 2, 1e-9) << "brighter light is no merit";
  before.searches = 0;
  Instance changed = instance_at(100, "one", 25);
  changed.inherit_comparisons(before);
  EXPECT_NEAR(changed.others.at("other")->log_odds, 18, 1e-9) << "other pixels, other odds";
}

class KnownInstancesTest : public testing::Test {
 protected:
  void compare_with(const std::vector<Rival>& found, bool covered = true) {
    instances_.compare("other", found, [covered](const cv::Rect&) { return covered; });
    instances_.compare("one", found, [covered](const cv::Rect&) { return covered; });
  }

  /// Margin of the only instance if `rival` is its only competitor.
  double margin_to(const Match& rival) {
    instances_.all()[0].others.clear();
    compare_with({rival_of(rival)});
    return judged(instances_.all()[0]).margin_place;
  }

  InstanceList instances_{0.25};
};

TEST_F(KnownInstancesTest, DetectionsAtThePlaceCompete) {
  instances_.admit(instance_at(100), kReach);
  compare_with({rival_at(104, "other", 12), rival_at(100, "other", 15), rival_at(96, "other", 9)});
  EXPECT_NEAR(judged(instances_.all()[0]).margin_place, 5, 1e-9) << "the best of them";
}

// A whole search compares only uncalibrated evidence, without the calibration by the fit of the
// outline and by other instances.
TEST_F(KnownInstancesTest, CalibrationDoesNotEnterTheComparison) {
  Instance firm = instance_at(100, "one", 24);
  firm.match.odds.calibration = -4;
  instances_.admit(firm, kReach);
  Match behind_another = instance_at(300, "one", 21).match;
  behind_another.odds.calibration = -6;
  compare_with({rival_at(100, "other", 20), rival_of(behind_another)});
  EXPECT_NEAR(judged(instances_.all()[0]).margin_place, 3, 1e-9) << "of 24 to 21";
  Instance loose = instance_at(102, "other", 21);
  loose.match.score = 0.95;
  loose.match.odds.calibration = 2;
  instances_.admit(loose, kReach);
  ASSERT_EQ(instances_.all().size(), 1u);
  compare_with({});
  EXPECT_NEAR(judged(instances_.all()[0]).margin_place, -3, 1e-9) << "of 21 to 24";
}

// The two objects were searched in the whole image at different times, with different clutter in
// view.
TEST_F(KnownInstancesTest, MoreClutterDoesNotWeakenARival) {
  instances_.admit(instance_at(100, "one", 24), kReach);
  Match crowded = instance_at(100, "other", 24).match;
  crowded.odds.clutter = 7;
  EXPECT_NEAR(margin_to(crowded), 0, 1e-9);
  instances_.all()[0].match.odds.clutter = 3;
  EXPECT_NEAR(margin_to(instance_at(100, "other", 24).match), -3, 1e-9)
      << "nor worse by its own lack of it";
}

TEST_F(KnownInstancesTest, APrintDifferenceDoesNotWeakenARival) {
  instances_.admit(instance_at(100, "one", 24), kReach);
  Match dirty = instance_at(100, "other", 15).match;
  dirty.odds.print = 9;
  EXPECT_NEAR(margin_to(dirty), 0, 1e-9);
}

TEST_F(KnownInstancesTest, GainByAnotherSizeDoesNotWeakenARival) {
  Instance resized = instance_at(100, "one", 24);
  resized.match.odds.resized = 5;
  instances_.admit(resized, kReach);
  EXPECT_NEAR(margin_to(instance_at(100, "other", 15).match), 4, 1e-9);
}

TEST_F(KnownInstancesTest, AnObjectNotYetSearchedForThereBlocksTheGrasp) {
  instances_.admit(instance_at(100), kReach);
  compare_with({}, false);
  EXPECT_FALSE(judged(instances_.all()[0]).graspable);
  compare_with({}, true);
  EXPECT_TRUE(judged(instances_.all()[0]).graspable);
}

TEST_F(KnownInstancesTest, OtherPlacesCompeteUnlessTheyAreInstances) {
  instances_.admit(instance_at(100), kReach);
  instances_.admit(instance_at(200), kReach);
  compare_with({rival_at(203, "one", 15), rival_at(100, "one", 14)});
  EXPECT_TRUE(judged(instances_.all()[0]).graspable);
  compare_with({rival_at(300, "one", 15)});
  EXPECT_NEAR(judged(instances_.all()[0]).margin_place, 5, 1e-9);
}

TEST_F(KnownInstancesTest, OtherObjectsElsewhereDoNotCompete) {
  instances_.admit(instance_at(100), kReach);
  compare_with({rival_at(200, "other", 30)});
  EXPECT_TRUE(judged(instances_.all()[0]).graspable);
}

TEST_F(KnownInstancesTest, TheBetterOfTwoAtOnePlaceStaysAndKeepsItsMargin) {
  Instance weaker = instance_at(102, "other", 18), better = instance_at(100);
  weaker.match.score = 0.8;
  ASSERT_NE(instances_.admit(weaker, kReach), nullptr);
  ASSERT_NE(instances_.admit(better, kReach), nullptr);
  ASSERT_EQ(instances_.all().size(), 1u);
  EXPECT_EQ(instances_.all()[0].match.name, "one");
  compare_with({});
  EXPECT_NEAR(judged(instances_.all()[0]).margin_place, 2, 1e-9);
  EXPECT_EQ(instances_.admit(weaker, kReach), nullptr);
}

// The other object was found at one pose only, and may fit better at another that overlaps.
TEST_F(KnownInstancesTest, ReplacingAnotherObjectIsNoComparisonWithIt) {
  Instance covered = instance_at(85, "other", 10);
  covered.match.score = 0.8;
  instances_.admit(covered, kReach);
  instances_.admit(instance_at(100), kReach);
  ASSERT_EQ(instances_.all().size(), 1u);
  EXPECT_FALSE(judged(instances_.all()[0]).graspable);
  compare_with({rival_at(100, "other", 20)});
  EXPECT_NEAR(judged(instances_.all()[0]).margin_place, 0, 1e-9);
}

TEST_F(KnownInstancesTest, ReplacingAnotherObjectEndsAnEarlierComparison) {
  for (const bool fresh : {true, false}) {
    Instance covered = instance_at(85, "other", 10), moved = instance_at(100);
    covered.match.score = 0.8;
    covered.match.fresh = fresh;
    moved.others["other"] = std::nullopt;
    instances_.all().clear();
    instances_.admit(covered, kReach);
    instances_.admit(moved, kReach);
    ASSERT_EQ(instances_.all().size(), 1u);
    EXPECT_FALSE(judged(instances_.all()[0]).graspable);
  }
}

TEST_F(KnownInstancesTest, AnInstanceOfAnEarlierImageIsReplacedUncompared) {
  Instance earlier = instance_at(102, "other", 10);
  earlier.match.score = 0.8;
  earlier.match.fresh = false;
  instances_.admit(earlier, kReach);
  instances_.admit(instance_at(100), kReach);
  ASSERT_EQ(instances_.all().size(), 1u);
  EXPECT_FALSE(judged(instances_.all()[0]).graspable) << "the light may have changed since then";
  compare_with({});
  EXPECT_GE(judged(instances_.all()[0]).margin_place, 20) << "nor does it compete";
}

}  // namespace
}  // namespace mbncc::incremental_search
