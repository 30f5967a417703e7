// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "cli/tool.hpp"

namespace mbncc::test {
namespace {

// The first example of the guide, as a new user would type it.
TEST(SimulateCommand, DrawsImagesThatCanBeTaughtAndFound) {
  TemporaryFolder folder;
  const std::string images = folder / "images/", library = folder / "library";
  ASSERT_EQ(run_tool({"simulate", "--out", images, "--count", "2"}).code, 0);
  ASSERT_EQ(run_tool({"learn", "--library", library, "--name", "wrench", "--before",
                      images + "before.png", "--after", images + "after.png"})
                .code,
            0);
  const ToolRun run = run_tool({"find", "--library", library, "--csv", images + "target_000.png",
                                images + "target_001.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto found = split(run.out, '\n'),
             truth = split(content_of_file(images + "truth.csv"), '\n');
  ASSERT_EQ(found.size(), 3u) << run.out;
  ASSERT_EQ(truth.size(), 3u);
  for (std::size_t i = 1; i < found.size(); ++i) {
    const auto pose = split(found[i], ','), true_pose = split(truth[i], ',');
    EXPECT_NEAR(std::stod(pose[3]), std::stod(true_pose[1]), 1);
    EXPECT_NEAR(std::stod(pose[4]), std::stod(true_pose[2]), 1);
    EXPECT_NEAR(std::remainder(std::stod(pose[5]) - std::stod(true_pose[3]), 360), 0, 1);
  }
}

TEST(SimulateCommand, UsesTheSimulatedCamerasParameters) {
  TemporaryFolder folder;
  const std::string images = folder / "images/";
  const ToolRun run =
      run_tool({"simulate", "--out", images, "--count", "1", "--set", "width=320", "--set",
                "height=200", "--set", "neighbours=0", "--set", "object_diameter=60"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(cv::imread(images + "before.png").size(), cv::Size(320, 200));
}

TEST(SimulateCommand, TheSeedDrawsOtherImages) {
  TemporaryFolder folder;
  for (const std::string seed : {"1", "2"})
    ASSERT_EQ(run_tool({"simulate", "--out", folder / seed, "--count", "1", "--seed", seed}).code,
              0);
  const cv::Mat one = cv::imread(folder / "1/before.png"),
                two = cv::imread(folder / "2/before.png");
  EXPECT_GT(cv::norm(one, two, cv::NORM_INF), 50);
}

TEST(SimulateCommand, RefusesScenesThatDoNotFit) {
  TemporaryFolder folder;
  const ToolRun run =
      run_tool({"simulate", "--out", folder / "images", "--set", "object_diameter=900"});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says("object_diameter")) << run.err;
}

}  // namespace
}  // namespace mbncc::test
