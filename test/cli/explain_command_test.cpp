// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "cli/tool.hpp"

namespace mbncc::test {
namespace {

class ExplainCommand : public testing::Test {
 protected:
  ExplainCommand() { EXPECT_EQ(run_tool(folder_.lesson("part")).code, 0); }

  std::vector<std::string> explain(const std::string& at = "195,125") const {
    return {"explain", "--library", folder_.library(), "--at", at, folder_ / "target.png"};
  }

  const LessonFolder folder_;
};

TEST_F(ExplainCommand, ExplainsADetection) {
  const ToolRun run = run_tool(explain());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("'part' at (195")) << run.out;
  EXPECT_TRUE(run.prints("Parts of the score:"));
  EXPECT_TRUE(run.prints("min_score 0.50 passed"));
}

TEST_F(ExplainCommand, NamesTheThresholdThatFailedAndCanBeRunAgain) {
  const std::string miss = folder_ / "a.miss";
  const ToolRun run =
      run_tool(explain() + std::vector<std::string>{"--set", "min_score=1", "--save", miss,
                                                    "--overlay", folder_ / "why.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("below min_score 1.00")) << run.out;
  EXPECT_TRUE(run.says("wrote " + miss));
  EXPECT_FALSE(cv::imread(folder_ / "why.png").empty());
  // The library may no longer exist when the miss is replayed.
  std::filesystem::remove_all(folder_.library());
  const ToolRun again = run_tool({"replay", miss});
  EXPECT_EQ(again.code, 0) << again.err;
  EXPECT_TRUE(again.prints("below min_score 1.00"));
  EXPECT_TRUE(again.prints("as when it was saved"));
  // --set changes the saved settings.
  const ToolRun lower = run_tool({"replay", miss, "--set", "min_score=0.25"});
  EXPECT_EQ(lower.code, 0) << lower.err;
  EXPECT_TRUE(lower.prints("min_score 0.25 passed")) << lower.out;
  EXPECT_FALSE(lower.prints("as when it was saved")) << lower.out;
  EXPECT_EQ(run_tool({"replay", miss, "--set", "min_scor=0.25"}).code, 2);
}

TEST_F(ExplainCommand, PrintsOneObjectPerLine) {
  const ToolRun run = run_tool(explain() + std::vector<std::string>{"--json"});
  const auto lines = split(run.out, '\n');
  ASSERT_EQ(lines.size(), 1u);
  const YAML::Node one = YAML::Load(lines[0]);
  EXPECT_EQ(one["name"].as<std::string>(), "part");
  EXPECT_GT(one["score"].as<double>(), 0.5);
  EXPECT_EQ(one["parts"].size(), 7u);
}

TEST_F(ExplainCommand, ExplainsRefusals) {
  const ToolRun outside = run_tool(explain("9999,5"));
  EXPECT_EQ(outside.code, 1);
  EXPECT_TRUE(outside.says("does not lie in the image of 320 x 240 px"));
  EXPECT_EQ(run_tool(explain() + std::vector<std::string>{"--name", "none"}).code, 1);
  const ToolRun broken = run_tool({"replay", folder_ / "target.png", folder_ / "nothing"});
  EXPECT_EQ(broken.code, 1);
  EXPECT_TRUE(broken.says("target.png: not a saved miss; give a file written by 'Save this miss'"));
  EXPECT_TRUE(broken.says("nothing: "));
}

}  // namespace
}  // namespace mbncc::test
