// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/demonstration.hpp"

#include <gtest/gtest.h>

#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

using Step = Demonstration::Step;

/// Still images of a small cell.
class DemonstrationTest : public testing::Test {
 protected:
  static sim::SceneConfig scene_config() {
    sim::SceneConfig config;
    config.size = {320, 240};
    return config;
  }

  StillShot shot(const std::vector<sim::Placed>& placed,
                 const std::optional<sim::Arm>& arm = std::nullopt) {
    ++number_;
    return {scene_.render(placed, number_, arm), 0.1 * static_cast<double>(number_), number_};
  }

  const sim::Placed part_{{11, 60, 1.6}, {150, 120, 0.3}};
  const sim::Scene scene_{scene_config()};
  std::uint64_t number_ = 0;
};

TEST_F(DemonstrationTest, TakesTheStillScenesBeforeAndAfter) {
  Demonstration demonstration;
  EXPECT_EQ(demonstration.update({}), Step::kWaitStill);
  EXPECT_EQ(demonstration.update(shot({part_})), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.update({}), Step::kMoving);
  EXPECT_EQ(demonstration.update(shot({})), Step::kReady);
  EXPECT_EQ(demonstration.before().number, 1u);
  EXPECT_EQ(demonstration.after().number, 2u);
}

TEST_F(DemonstrationTest, AnArmThatComesAndGoesIsNoObject) {
  Demonstration demonstration;
  demonstration.update(shot({part_}));
  const sim::Arm arm{{160, 120, -kPi / 2}};
  EXPECT_EQ(demonstration.update(shot({part_}, arm)), Step::kAtBorder) << "it pauses";
  EXPECT_EQ(demonstration.update(shot({part_})), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.update(shot({})), Step::kReady);
}

TEST_F(DemonstrationTest, AnObjectThatWasPutDownBelongsToTheSceneBefore) {
  Demonstration demonstration;
  demonstration.update(shot({}));
  EXPECT_EQ(demonstration.update(shot({part_})), Step::kReady);
  demonstration.continue_waiting();
  EXPECT_EQ(demonstration.restart_reason(), Demonstration::RestartReason::kPutDown);
  EXPECT_EQ(demonstration.before().number, 2u);
  const StillShot empty = shot({});
  EXPECT_EQ(demonstration.update(empty), Step::kReady);
  EXPECT_EQ(demonstration.after().number, 3u);
}

TEST_F(DemonstrationTest, KeepsTheGivenImageBefore) {
  Demonstration demonstration(scene_.render({part_}, 77));
  EXPECT_EQ(demonstration.update(shot({part_})), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.update(shot({})), Step::kReady);
  demonstration.continue_waiting();
  EXPECT_EQ(demonstration.before().number, 0u);
}

TEST_F(DemonstrationTest, AHandVisibleAtTheStartIsNoObject) {
  Demonstration demonstration;
  const sim::Arm arm{{160, 120, -kPi / 2}};
  demonstration.update(shot({part_}, arm));
  EXPECT_EQ(demonstration.update(shot({part_})), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.restart_reason(), Demonstration::RestartReason::kEdgeLeft);
  EXPECT_EQ(demonstration.update(shot({})), Step::kReady);
  EXPECT_EQ(demonstration.before().number, 2u);
}

TEST_F(DemonstrationTest, ChangedLightRestartsWithANewImageBefore) {
  Demonstration demonstration;
  demonstration.update(shot({part_}));
  StillShot dim = shot({part_});
  dim.image *= 0.5;
  EXPECT_EQ(demonstration.update(dim), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.restart_reason(), Demonstration::RestartReason::kLight);
  EXPECT_EQ(demonstration.before().number, 2u);
}

TEST_F(DemonstrationTest, LightChangeDuringAStillPeriodIsDetected) {
  Demonstration demonstration;
  const StillShot first = shot({part_});
  demonstration.update(first);
  StillShot dim = first;
  dim.image = cv::Mat(0.5 * first.image);  // stored beside the first image, which stays unchanged
  dim.stamp += 2;
  EXPECT_EQ(demonstration.update(dim), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.restart_reason(), Demonstration::RestartReason::kLight);
}

TEST_F(DemonstrationTest, ChangedSceneRestartsWithANewImageBefore) {
  Demonstration demonstration;
  demonstration.update(shot({part_}));
  StillShot other = shot({part_});
  cv::randu(other.image, 0, 255);
  EXPECT_EQ(demonstration.update(other), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.restart_reason(), Demonstration::RestartReason::kEverything);
  EXPECT_EQ(demonstration.update(shot({part_})), Step::kWaitRemoval);
  EXPECT_EQ(demonstration.update(shot({})), Step::kReady);
}

TEST_F(DemonstrationTest, ImagesOfAnotherSizeAreIgnored) {
  Demonstration demonstration;
  demonstration.update(shot({part_}));
  StillShot other = shot({});
  other.image = other.image(cv::Rect(0, 0, 100, 100));
  EXPECT_EQ(demonstration.update(other), Step::kWaitRemoval);
}

}  // namespace
}  // namespace mbncc
