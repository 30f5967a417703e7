// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgproc.hpp>

#include "cli/tool.hpp"
#include "mbncc/library/object_library.hpp"

namespace mbncc::test {
namespace {

using Words = std::vector<std::string>;

TEST(LearnCommand, StoresALessonByMapAndReportsIt) {
  const LessonFolder folder;
  const ToolRun run = run_tool(folder.lesson("part") + Words{"--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const YAML::Node report = YAML::Load(run.out);  // JSON is YAML
  EXPECT_EQ(report["name"].as<std::string>(), "part");
  EXPECT_EQ(report["error_code"].as<int>(), 0);
  EXPECT_NEAR(report["reference"]["x"].as<double>(), 130, 1.5);
  EXPECT_NEAR(report["reference"]["y"].as<double>(), 110, 1.5);
  const cv::Mat map = cv::imread(folder / "map.png", cv::IMREAD_GRAYSCALE);
  EXPECT_EQ(report["area"].as<int>(), cv::countNonZero(map));
  EXPECT_GT(report["radius"].as<double>(), 20);
  EXPECT_GT(report["timings_ms"]["total"].as<double>(), 0);
  EXPECT_TRUE(report["reasons"].IsSequence());
  EXPECT_NE(ObjectLibrary(folder.library()).load()->find("part"), nullptr);
}

TEST(LearnCommand, APhotographIsNoMap) {
  const LessonFolder folder;
  const cv::Mat colour = cv::imread(folder / "before.png");
  cv::Mat grey;
  cv::cvtColor(colour, grey, cv::COLOR_BGR2GRAY);
  folder.write("grey.png", grey);
  for (const char* photograph : {"before.png", "grey.png"}) {
    const ToolRun run = run_tool({"learn", "--library", folder.library(), "--name", "part",
                                  "--before", folder / "before.png", "--map", folder / photograph});
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(run.says("a photograph, not a map")) << run.err;
  }
  // Smoothed edges and the noise of JPEG are borne.
  cv::Mat map = cv::imread(folder / "map.png", cv::IMREAD_GRAYSCALE);
  cv::GaussianBlur(map, map, {}, 1.5);
  folder.write("map.jpg", map);
  EXPECT_EQ(run_tool({"learn", "--library", folder.library(), "--name", "part", "--before",
                      folder / "before.png", "--map", folder / "map.jpg"})
                .code,
            0);
}

TEST(LearnCommand, LearnsFromTheDifferenceOfTwoPictures) {
  const LessonFolder folder;
  const ToolRun run = run_tool({"learn", "--library", folder.library(), "--name", "part",
                                "--before", folder / "before.png", "--after", folder / "after.png",
                                "--roi", "60,40,140,140", "--stages", folder / "stages"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("learned 'part', revision 1"));
  const auto object = ObjectLibrary(folder.library()).load()->find("part");
  const cv::Mat truth = cv::imread(folder / "map.png", cv::IMREAD_GRAYSCALE);
  const cv::Mat learned = full_size_map(object->views.front());
  EXPECT_GT(cv::countNonZero(truth & learned), 0.8 * cv::countNonZero(truth | learned));
  EXPECT_FALSE(std::filesystem::is_empty(folder / "stages"));
}

TEST(LearnCommand, KeepsADeclaredSymmetryUntilTheObjectIsReplaced) {
  const LessonFolder folder;
  const auto stored = [&] {
    return ObjectLibrary(folder.library()).load()->find("part")->symmetry;
  };
  ASSERT_EQ(run_tool(folder.lesson("part") + Words{"--symmetry", "4"}).code, 0);
  EXPECT_EQ(stored(), 4);
  const ToolRun other = run_tool(folder.lesson("part") + Words{"--add-view", "--symmetry", "2"});
  EXPECT_EQ(other.code, 1);
  EXPECT_TRUE(other.says("cannot change its symmetry")) << other.err;
  folder.write("before.png", 0.7 * LessonFolder::scene().render({LessonFolder::learned()}, 1));
  ASSERT_EQ(run_tool(folder.lesson("part") + Words{"--add-view"}).code, 0);
  EXPECT_EQ(stored(), 4);
  ASSERT_EQ(run_tool(folder.lesson("part") + Words{"--overwrite"}).code, 0);
  EXPECT_EQ(stored(), std::nullopt);
}

TEST(LearnCommand, StrokesCorrectTheMap) {
  const LessonFolder folder;
  const Words strokes{"--include", "20,20,40,20", "--exclude", "130,110", "--stroke-width", "7"};
  const ToolRun run = run_tool(folder.lesson("part") + strokes);
  ASSERT_EQ(run.code, 0) << run.err;
  const auto object = ObjectLibrary(folder.library()).load()->find("part");
  const cv::Mat learned = full_size_map(object->views.front());
  EXPECT_EQ(learned.at<uchar>(20, 30), 255);
  EXPECT_EQ(learned.at<uchar>(110, 130), 0);
}

TEST(LearnCommand, AClickShowsTheObject) {
  const LessonFolder folder;
  const ToolRun run =
      run_tool({"learn", "--library", folder.library(), "--name", "part", "--before",
                folder / "before.png", "--after", folder / "after.png", "--click", "130,110"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto object = ObjectLibrary(folder.library()).load()->find("part");
  const cv::Mat truth = cv::imread(folder / "map.png", cv::IMREAD_GRAYSCALE);
  const cv::Mat learned = full_size_map(object->views.front());
  EXPECT_GT(cv::countNonZero(truth & learned), 0.8 * cv::countNonZero(truth | learned));
}

TEST(LearnCommand, StrokesAndClicksAreCheckedBeforeAnythingIsRead) {
  const LessonFolder folder;
  for (const Words& wrong :
       {Words{"--include", "1,2,3"}, Words{"--include", "1,x"}, Words{"--exclude", "1,2,"},
        Words{"--stroke-width", "5"}, Words{"--include", "1,2", "--stroke-width", "-1"},
        Words{"--click", "1,2"}}) {
    const ToolRun run = run_tool(folder.lesson("part") + wrong);
    EXPECT_EQ(run.code, 2) << wrong.front() << ' ' << wrong.back();
  }
}

TEST(LearnCommand, NamesAreGuarded) {
  const LessonFolder folder;
  ASSERT_EQ(run_tool(folder.lesson("part")).code, 0);
  const ToolRun taken = run_tool(folder.lesson("part") + Words{"--json"});
  EXPECT_EQ(taken.code, 1);
  EXPECT_EQ(YAML::Load(taken.out)["error"].as<std::string>(), "NAME_TAKEN");
  EXPECT_TRUE(taken.says("Replace it (--overwrite), add a view to it (--add-view)")) << taken.err;
  const ToolRun unknown = run_tool(folder.lesson("other") + Words{"--add-view"});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_TRUE(unknown.says("does not hold 'other'"));
  EXPECT_TRUE(unknown.says("without --add-view")) << unknown.err;
  for (const char* name : {"../x", "1st", "with space", "\xc3\xa4", "x.png"}) {
    const ToolRun bad = run_tool(folder.lesson(name));
    EXPECT_EQ(bad.code, 1) << name;
    EXPECT_TRUE(bad.says("Use a letter")) << bad.err;
  }
  EXPECT_EQ(ObjectLibrary(folder.library()).load()->objects.size(), 1u);
}

TEST(LearnCommand, OverwriteMakesTheNextRevision) {
  const LessonFolder folder;
  ASSERT_EQ(run_tool(folder.lesson("part")).code, 0);
  ASSERT_EQ(run_tool(folder.lesson("part") + Words{"--overwrite", "--label", "A part"}).code, 0);
  const auto object = ObjectLibrary(folder.library()).load()->find("part");
  EXPECT_EQ(object->revision, 2u);
  EXPECT_EQ(object->label, "A part");
}

TEST(LearnCommand, AddedViewsShareOneObjectFrame) {
  const LessonFolder folder;
  ASSERT_EQ(run_tool(folder.lesson("part")).code, 0);
  folder.write("map2.png", LessonFolder::scene().true_map(LessonFolder::placed()));
  const ToolRun run =
      run_tool({"learn", "--library", folder.library(), "--name", "part", "--before",
                folder / "target.png", "--map", folder / "map2.png", "--add-view"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto object = ObjectLibrary(folder.library()).load()->find("part");
  ASSERT_EQ(object->views.size(), 2u);
  EXPECT_EQ(object->revision, 2u);
  EXPECT_NEAR(object->views[1].reference.x, 195, 1.5);
  EXPECT_NEAR(object->views[1].reference.y, 125, 1.5);
  EXPECT_NEAR(to_degrees(object->views[1].reference.theta), 70, 2);
  const Words forget{"forget", "--library", folder.library(), "--name", "part", "--view"};
  EXPECT_TRUE(run_tool(forget + Words{"3"}).says("no view 3"));
  EXPECT_EQ(run_tool(forget + Words{"0"}).code, 2);
  EXPECT_TRUE(run_tool(forget + Words{"1"}).prints("1 left"));
  const auto left = ObjectLibrary(folder.library()).load()->find("part");
  ASSERT_EQ(left->views.size(), 1u);
  EXPECT_NEAR(left->views[0].reference.x, 195, 1.5);
  EXPECT_TRUE(run_tool(forget + Words{"1"}).says("only view"));
}

TEST(LearnCommand, AViewOfAnotherObjectIsNotAdded) {
  const LessonFolder folder;
  ASSERT_EQ(run_tool(folder.lesson("part")).code, 0);
  sim::SceneObject other;
  other.seed = 77;
  other.elongation = 3;
  const sim::Placed placed{other, {180, 120, 0}};
  folder.write("other.png", LessonFolder::scene().render({placed}, 9));
  folder.write("other_map.png", LessonFolder::scene().true_map(placed));
  const ToolRun run =
      run_tool({"learn", "--library", folder.library(), "--name", "part", "--before",
                folder / "other.png", "--map", folder / "other_map.png", "--add-view"});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says("was not found in the new picture")) << run.err;
  EXPECT_EQ(ObjectLibrary(folder.library()).load()->find("part")->views.size(), 1u);
}

TEST(LearnCommand, AnObjectLikeAKnownOneIsStoredWithAWarning) {
  const LessonFolder folder;
  ASSERT_EQ(run_tool(folder.lesson("part")).code, 0);
  const ToolRun run = run_tool(folder.lesson("twin") + Words{"--json"});
  ASSERT_EQ(run.code, 0) << run.err;
  const YAML::Node report = YAML::Load(run.out);
  EXPECT_EQ(report["verdict"].as<std::string>(), "MARGINAL");
  EXPECT_EQ(report["quality"]["confusable_with"].as<std::string>(), "part");
}

TEST(LearnCommand, RefusalsAreReportedInJsonToo) {
  const LessonFolder folder;
  const ToolRun run = run_tool({"learn", "--library", folder.library(), "--name", "part",
                                "--before", folder / "none.png", "--roi", "1,1,50,50", "--json"});
  EXPECT_EQ(run.code, 1);
  const YAML::Node report = YAML::Load(run.out);
  EXPECT_EQ(report["error"].as<std::string>(), "NO_IMAGE");
  EXPECT_FALSE(report["stored"].as<bool>());
}

TEST(LearnCommand, WhatCannotBeStoredIsReportedInJsonToo) {
  const LessonFolder folder;
  const ToolRun run = run_tool(folder.lesson("part") + Words{"--json", "--label", "two\nlines"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(YAML::Load(run.out)["error"].as<std::string>(), "NAME_INVALID");
}

TEST(LearnCommand, FoldersThatCannotBeMadeAreReportedInJsonToo) {
  const LessonFolder folder;
  Words elsewhere = folder.lesson("part");
  *(std::find(elsewhere.begin(), elsewhere.end(), "--library") + 1) = "/proc/none";
  for (const Words& words : {elsewhere, folder.lesson("part") + Words{"--stages", "/proc/none"}}) {
    const ToolRun run = run_tool(words + Words{"--json"});
    EXPECT_EQ(run.code, 1);
    EXPECT_EQ(YAML::Load(run.out)["error"].as<std::string>(), "STORAGE");
    EXPECT_TRUE(run.says("'part' was not stored: /proc/none: ")) << run.err;
  }
}

TEST(LearnCommand, UnusablePicturesAndRegionsStoreNothing) {
  const LessonFolder folder;
  folder.write("small.png", cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(90)));
  folder.write("black.png", cv::Mat::zeros(240, 320, CV_8UC1));
  std::ofstream(folder / "text.png") << "no picture";
  const Words start = {"learn", "--library", folder.library(), "--name", "part"};
  const std::vector<std::pair<Words, std::string>> table = {
      {{"--before", folder / "none.png", "--roi", "1,1,50,50"}, "there is no such file"},
      {{"--before", folder / "text.png", "--roi", "1,1,50,50"}, "neither a PNG nor a JPEG"},
      {{"--before", folder / "before.png", "--map", folder / "small.png"}, "100 x 100 pixels"},
      {{"--before", folder / "before.png", "--after", folder / "small.png"}, "100 x 100 pixels"},
      {{"--before", folder / "before.png", "--map", folder / "black.png"}, "was not stored"},
      {{"--before", folder / "before.png", "--roi", "400,10,50,50"}, "region"},
      {{"--before", folder / "after.png", "--after", folder / "empty.png"}, "no difference"},
  };
  for (const auto& [words, sentence] : table) {
    const ToolRun run = run_tool(start + words);
    EXPECT_EQ(run.code, 1) << sentence;
    EXPECT_TRUE(run.says(sentence)) << run.err;
  }
  if (std::filesystem::exists(folder.library())) {
    EXPECT_TRUE(ObjectLibrary(folder.library()).load()->objects.empty());
  }
}

TEST(LearnCommand, LibraryThatCannotBeWrittenIsReported) {
  const LessonFolder folder;
  std::ofstream(folder.library()) << "a file where the folder should be";
  const ToolRun run = run_tool(folder.lesson("part"));
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says(folder.library())) << run.err;
}

}  // namespace
}  // namespace mbncc::test
