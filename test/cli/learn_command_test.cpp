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
  // Smoothed edges and JPEG noise are tolerated.
  cv::Mat map = cv::imread(folder / "map.png", cv::IMREAD_GRAYSCALE);
  cv::GaussianBlur(map, map, {}, 1.5);
  folder.write("map.jpg", map);
  EXPECT_EQ(run_tool({"learn", "--library", folder.library(), "--name", "part", "--before",
                      folder / "before.png", "--map", folder / "map.jpg"})
                .code,
            0);
}

TEST(LearnCommand, LearnsFromTheDifferenceOfTwoImages) {
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

TEST(LearnCommand, NamesAreChecked) {
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
  EXPECT_TRUE(run_tool(forget + Words{"1"})
                  .says("'part' has no other view; use 'mbncc forget --name part'"));
  EXPECT_TRUE(run_tool(forget + Words{"2"}).says("there is no view 2; it has one view"));
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
  EXPECT_TRUE(run.says("was not found in the new image")) << run.err;
  EXPECT_TRUE(run.says("Teach another side under its own name, or use --overwrite.")) << run.err;
  EXPECT_EQ(ObjectLibrary(folder.library()).load()->find("part")->views.size(), 1u);
}

TEST(LearnCommand, AnObjectSimilarToAKnownOneIsStoredWithAWarning) {
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

TEST(LearnCommand, StorageErrorsAreReportedInJsonToo) {
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

TEST(LearnCommand, UnusableImagesAndRegionsStoreNothing) {
  const LessonFolder folder;
  folder.write("small.png", cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(90)));
  folder.write("black.png", cv::Mat::zeros(240, 320, CV_8UC1));
  std::ofstream(folder / "text.png") << "no image";
  const Words start = {"learn", "--library", folder.library(), "--name", "part"};
  const std::vector<std::pair<Words, std::string>> table = {
      {{"--before", folder / "none.png", "--roi", "1,1,50,50"}, "there is no such file.\n"},
      {{"--before", folder.path(), "--roi", "1,1,50,50"}, "a folder; give the images in it.\n"},
      {{"--before", folder / "text.png", "--roi", "1,1,50,50"}, "convert it to PNG.\n"},
      {{"--before", folder / "before.png", "--map", folder / "before.png"},
       "white on the object and black elsewhere.\n"},
      {{"--before", folder / "before.png", "--map", folder / "small.png"}, "100 x 100 pixels"},
      {{"--before", folder / "before.png", "--after", folder / "small.png"}, "100 x 100 pixels"},
      {{"--before", folder / "before.png", "--map", folder / "black.png"},
       "The map is black everywhere. Paint the object white.\n"},
      {{"--before", folder / "before.png", "--roi", "400,10,50,50"},
       "The region does not lie in the image."},
      {{"--before", folder / "before.png", "--roi", "0,0,320,240"},
       "The region is the whole image. Draw it close around the object.\n"},
      {{"--before", folder / "before.png", "--roi", "120,100,5,5"},
       "The region is only 5 x 5 px. Give at least 8 x 8 px.\n"},
      {{"--before", folder / "before.png", "--roi", "120,100,20,20"},
       "The region (roi) may cut the object off: draw it larger"},
      {{"--before", folder / "before.png", "--click", "400,10"},
       "Give a point inside the image of 320 x 240 px.\n"},
      {{"--before", folder / "before.png", "--click", "290,20"},
       "No object stands out at the click. Click on the object itself"},
      {{"--before", folder / "before.png", "--map", folder / "map.png", "--include",
        "400,10,410,10"},
       "Give a point inside the image of 320 x 240 px.\n"},
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

TEST(LearnCommand, OutputFoldersThatAreFilesAreRefused) {
  const LessonFolder folder;
  for (const char* inside : {"map.png", "map.png/deeper"}) {
    const ToolRun run = run_tool(folder.lesson("part") + Words{"--stages", folder / inside});
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(run.says(folder / "map.png: is a file; give a folder.\n")) << run.err;
    EXPECT_FALSE(run.says("wrote")) << run.err;
  }
  const ToolRun written = run_tool(folder.lesson("part") + Words{"--stages", folder / "stages"});
  EXPECT_TRUE(written.says("images of the steps to " + (folder / "stages"))) << written.err;
  const Words find{"find", "--library", folder.library(), "--overlay"};
  const ToolRun overlay = run_tool(find + Words{folder / "map.png", folder / "target.png"});
  EXPECT_TRUE(overlay.says("is a file; give a folder")) << overlay.err;
  const ToolRun none = run_tool(find + Words{folder / "marked", folder / "none.png"});
  EXPECT_FALSE(none.says("wrote")) << none.err;
  const ToolRun map = run_tool({"map", "--library", folder.library(), "--name", "part", "--out",
                                folder / "map.png/out.png"});
  EXPECT_TRUE(map.says("map.png: is a file; give a folder")) << map.err;
}

TEST(LearnCommand, ALibraryThatIsAFileIsRefused) {
  const LessonFolder folder;
  std::ofstream(folder.library()) << "a file where the folder should be";
  for (const Words& words : {folder.lesson("part"), Words{"list", "--library", folder.library()}}) {
    const ToolRun run = run_tool(words);
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(run.says(folder.library() + ": is a file; give a folder")) << run.err;
  }
}

TEST(LearnCommand, TheDefaultLibraryIsMadeWithItsParentsAndItsFileIsNamed) {
  const LessonFolder folder;
  const std::string home = ::getenv("HOME") == nullptr ? "" : ::getenv("HOME");
  ASSERT_EQ(::setenv("HOME", (folder / "home").c_str(), 1), 0);
  const Words lesson = {"learn", "--name",          "part", "--before", folder / "before.png",
                        "--map", folder / "map.png"};
  const ToolRun missing = run_tool({"list"});
  const ToolRun plain = run_tool(lesson), json = run_tool(lesson + Words{"--overwrite", "--json"});
  const ToolRun list = run_tool({"list"});
  ASSERT_EQ(::setenv("HOME", home.c_str(), 1), 0);
  const std::string file = folder / "home/.ros/mbncc_library/part.png";
  EXPECT_TRUE(missing.says("'mbncc learn' makes one")) << missing.err;
  ASSERT_EQ(plain.code, 0) << plain.err;
  EXPECT_TRUE(plain.prints("stored in " + file + "\n")) << plain.out;
  EXPECT_EQ(YAML::Load(json.out)["file"].as<std::string>(), file);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_TRUE(list.prints("part ")) << list.err;
  using std::filesystem::perms;
  EXPECT_EQ(std::filesystem::status(folder / "home/.ros").permissions() & perms::others_write,
            perms::none);
}

}  // namespace
}  // namespace mbncc::test
