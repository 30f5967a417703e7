// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "cli/tool.hpp"

namespace mbncc::test {
namespace {

class EvaluateCommand : public testing::Test {
 protected:
  EvaluateCommand() { EXPECT_EQ(run_tool(folder_.lesson("part")).code, 0); }

  ToolRun evaluate(const std::string& truth, const std::vector<std::string>& more = {}) const {
    std::ofstream(folder_ / "truth.csv") << truth;
    return run_tool(std::vector<std::string>{"evaluate", "--library", folder_.library(), "--truth",
                                             folder_ / "truth.csv", folder_ / "target.png",
                                             folder_ / "empty.png"} +
                    more);
  }

  const LessonFolder folder_;
};

constexpr const char* kRight = "image,name,x,y,theta_deg\ntarget.png,part,195,125,70\n";

TEST_F(EvaluateCommand, CountsDetections) {
  const ToolRun run = evaluate(kRight);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("2 images with 1 instances")) << run.out;
  EXPECT_TRUE(run.prints("recall: 100.0 % (1 of 1)"));
  EXPECT_TRUE(run.prints("0 wrong grasps"));
}

TEST_F(EvaluateCommand, ReadsTheFilesThatSpreadsheetsWrite) {
  const std::string written =
      "\xEF\xBB\xBFimage,\"name\",x,y,theta_deg,\r\n\"target.png\",\"part\",\"195\",125,70,\r\n";
  const ToolRun run = evaluate(written);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("recall: 100.0 % (1 of 1)")) << run.out;
  EXPECT_TRUE(evaluate("image,x,y\ntarget.png,\"1\"\"2\",3\n").says("not a number: '1\"2'"));
}

TEST_F(EvaluateCommand, WritesAPageWithImagesOfFaults) {
  const ToolRun run =
      evaluate("image,x,y,theta_deg\ntarget.png,30,30,0\n", {"--page", folder_ / "page", "--json"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.says("wrote " + (folder_ / "page/index.html")));
  const std::string page = content_of_file(folder_ / "page/index.html");
  EXPECT_NE(page.find("recall: 0.0 %"), std::string::npos) << page;
  EXPECT_NE(page.find("image_1.png"), std::string::npos);
  EXPECT_FALSE(cv::imread(folder_ / "page/image_1.png").empty());
  const auto lines = split(run.out, '\n');
  ASSERT_EQ(lines.size(), 3u) << "a line per image, the figures last";
  EXPECT_EQ(YAML::Load(lines[0])["missed"].size(), 1u);
  EXPECT_EQ(YAML::Load(lines[0])["wrong"].size(), 1u);
  EXPECT_EQ(YAML::Load(lines[2])["recall"].as<double>(), 0);
}

TEST_F(EvaluateCommand, AWrongTruthFileIsExplained) {
  EXPECT_TRUE(evaluate("x,y\n").says("no column 'image'"));
  EXPECT_TRUE(
      evaluate("image,x,y\ntarget.png,12,left\n").says("line 2: y is not a number: 'left'"));
  EXPECT_TRUE(evaluate("image,name,x,y,theta_deg\ntarget.png,nut,1,2,3\n").says("no object 'nut'"));
  EXPECT_EQ(evaluate("").code, 1);
}

TEST_F(EvaluateCommand, AnAngleIsNotTakenToBeZero) {
  for (const char* truth :
       {"image,x,y\ntarget.png,195,125\n", "image,x,y,theta_deg\ntarget.png,195,125,\n"}) {
    const ToolRun run = evaluate(truth);
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(run.says("line 2 has no theta_deg; give the angle in degrees")) << run.err;
  }
}

TEST_F(EvaluateCommand, ImagesOfTheSameNameInTwoFoldersAreKeptApart) {
  for (const std::string name : {"s1", "s2"}) std::filesystem::create_directory(folder_ / name);
  folder_.write("s1/x.png", cv::imread(folder_ / "target.png"));
  folder_.write("s2/x.png", cv::imread(folder_ / "empty.png"));
  const auto instances_in = [&](const std::string& truth) {
    std::ofstream(folder_ / "truth.csv") << truth;
    const ToolRun run =
        run_tool({"evaluate", "--library", folder_.library(), "--truth", folder_ / "truth.csv",
                  "--json", folder_ / "s1", folder_ / "s2/x.png"});
    EXPECT_FALSE(run.says("not given")) << run.err;
    const auto lines = split(run.out, '\n');
    EXPECT_EQ(lines.size(), 3u) << run.out;
    return YAML::Load(lines.back())["instances"].as<int>();
  };
  const std::string header = "image,x,y,theta_deg\n";
  EXPECT_EQ(instances_in(header + "s1/x.png,195,125,70\n./s2/x.png,,,\n"), 1);
  EXPECT_EQ(instances_in(header + (folder_ / "s1/x.png") + ",195,125,70\nx.png,,,\n"), 1);
  EXPECT_EQ(instances_in(header + "x.png,195,125,70\n"), 2) << "a name alone is that of both";
}

TEST_F(EvaluateCommand, ImagesOfAnotherSizeAreReported) {
  folder_.write("target.png", cv::imread(folder_ / "target.png")(cv::Rect(60, 30, 230, 190)));
  const ToolRun run = evaluate("image,x,y,theta_deg\ntarget.png,135,95,70\n");
  EXPECT_TRUE(run.prints("recall: 100.0 %")) << run.out;
  EXPECT_TRUE(
      run.says("target.png: part was learned in images of 320 x 240, this one is 230 x 190"))
      << run.err;
  EXPECT_FALSE(run.says("empty.png")) << run.err;
}

TEST_F(EvaluateCommand, SkippedObjectsAreReported) {
  ASSERT_EQ(run_tool(folder_.lesson("twin")).code, 0);
  const ToolRun run = evaluate(kRight, {"--set", "time_budget=1e-9"});
  EXPECT_TRUE(run.says("target.png: not searched twin: time budget exceeded")) << run.err;
}

TEST_F(EvaluateCommand, SharesOfNothingAreNotNumbers) {
  const ToolRun run = evaluate("image,x,y\nempty.png,,\n", {"--set", "min_score=1"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("recall: - (0 of 0), graspable - (0 of 0)")) << run.out;
  EXPECT_TRUE(run.prints("precision: - (0 of 0)")) << run.out;
  EXPECT_TRUE(run.prints("position - px median")) << run.out;
  const ToolRun json = evaluate("image,x,y\nempty.png,,\n", {"--set", "min_score=1", "--json"});
  const YAML::Node figures = YAML::Load(split(json.out, '\n').back());
  for (const char* key : {"recall", "precision", "precision_graspable", "place_median_px"})
    EXPECT_TRUE(figures[key].IsNull()) << key;
}

TEST_F(EvaluateCommand, UnknownColumnsAreRefused) {
  const ToolRun run = evaluate("image,name,x,y,theta_dge\ntarget.png,part,195,125,70\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says("its column 'theta_dge' is unknown; did you mean 'theta_deg'?")) << run.err;
}

TEST_F(EvaluateCommand, ABinaryTruthFileIsNotPrinted) {
  const ToolRun run = evaluate("\x89PNG\r\n\x1a\n,x,y\n");
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says("truth.csv: not a text file; give a CSV file with the columns")) << run.err;
  EXPECT_EQ(run.err.find('\x89'), std::string::npos);
  EXPECT_EQ(evaluate("image,x,y\nübung.png,,\n").code, 0) << "names in UTF-8 are text";
}

TEST_F(EvaluateCommand, ListedImagesThatWereNotGivenAreNamed) {
  const std::string truth = std::string(kRight) + "lost.png,part,1,2,3\n";
  EXPECT_TRUE(evaluate(truth).says("1 listed images were not given: lost.png\n"));
  const ToolRun json = evaluate(truth, {"--json"});
  EXPECT_EQ(YAML::Load(split(json.out, '\n').back())["not_given"].as<int>(), 1);
  EXPECT_FALSE(evaluate(kRight).says("not given"));
}

TEST_F(EvaluateCommand, AnUnreadableImageIsCountedAndTheOthersSearched) {
  const ToolRun run = evaluate(kRight, {folder_ / "none.png"});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.prints("1 images could not be read"));
  EXPECT_TRUE(run.prints("recall: 100.0 % (1 of 1)"));
}

}  // namespace
}  // namespace mbncc::test
