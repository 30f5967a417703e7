// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <opencv2/imgproc.hpp>

#include "cli/tool.hpp"
#include "mbncc/library/object_library.hpp"

namespace mbncc::test {
namespace {

using Words = std::vector<std::string>;

constexpr const char* kHeader =
    "image,name,instance,x,y,theta_deg,score,similarity,margin_place,margin_angle,graspable,ms";

class FindCommand : public testing::Test {
 protected:
  FindCommand() { learned_ = run_tool(folder_.lesson("part")).code; }

  void SetUp() override { ASSERT_EQ(learned_, 0); }

  ToolRun find(const Words& words) const {
    return run_tool(Words{"find", "--library", folder_.library()} + words);
  }

  LessonFolder folder_;
  int learned_ = -1;
};

TEST_F(FindCommand, CsvHasARowPerDetectionAndOnePerEmptyImage) {
  const ToolRun run = find({"--csv", folder_ / "target.png", folder_ / "empty.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto lines = split(run.out, '\n');
  ASSERT_EQ(lines.size(), 3u) << run.out;
  EXPECT_EQ(lines[0], kHeader);
  const auto found = split(lines[1], ',');
  ASSERT_EQ(found.size(), 12u);
  EXPECT_EQ(found[0], folder_ / "target.png");
  EXPECT_EQ(found[1], "part");
  EXPECT_EQ(found[2], "0");
  EXPECT_NEAR(std::stod(found[3]), 195, 1);
  EXPECT_NEAR(std::stod(found[4]), 125, 1);
  EXPECT_NEAR(std::stod(found[5]), 70, 1);
  EXPECT_GT(std::stod(found[6]), 0.5);
  EXPECT_GT(std::stod(found[11]), 0);
  EXPECT_EQ(lines[2].rfind(folder_ / "empty.png" + ",,,,,,,,,,,", 0), 0u) << lines[2];
}

TEST_F(FindCommand, JsonContainsAllFieldsOfADetection) {
  const ToolRun run = find({"--json", folder_ / "target.png", folder_ / "empty.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto lines = split(run.out, '\n');
  ASSERT_EQ(lines.size(), 2u) << "one image a line";
  const YAML::Node images[] = {YAML::Load(lines[0]), YAML::Load(lines[1])};
  EXPECT_EQ(images[0]["width"].as<int>(), LessonFolder::kWidth);
  ASSERT_EQ(images[0]["objects"].size(), 1u);
  const YAML::Node object = images[0]["objects"][0];
  for (const char* key : {"name", "revision", "instance", "x", "y", "theta_deg", "scale", "score",
                          "similarity", "margin_place", "margin_angle", "visible", "symmetry",
                          "graspable", "ambiguous", "reasons", "covariance", "outline"})
    EXPECT_TRUE(object[key]) << key;
  EXPECT_EQ(object["covariance"].size(), 9u);
  EXPECT_EQ(images[1]["objects"].size(), 0u);
}

TEST_F(FindCommand, JsonIsUtf8ForAnyFileName) {
  const std::string name = "caf\xc3\xa9_\xff\xc3.png";
  folder_.write(name, cv::imread(folder_ / "empty.png"));
  const ToolRun run = find({"--json", folder_ / name});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("caf\xc3\xa9_\\ufffd\\ufffd.png\"")) << run.out;
}

TEST_F(FindCommand, UnreadableImagesDoNotStopTheOthers) {
  const cv::Mat image = cv::imread(folder_ / "target.png");
  cv::Mat deep;
  image.convertTo(deep, CV_16UC3, 256);
  folder_.write("deep.png", deep);
  folder_.write("whole.jpg", image);
  for (const char* name : {"whole.jpg", "target.png"}) {
    const std::string bytes = content_of_file(folder_ / name);
    std::ofstream(folder_ / ("cut_" + std::string(name)), std::ios::binary)
        << bytes.substr(0, bytes.size() / 2);
  }
  folder_.write("one.png", image(cv::Rect(0, 0, 1, 1)));
  std::string huge = content_of_file(folder_ / "target.png");
  huge.replace(16, 8, std::string("\0\0\x1f\x40\0\0\x1f\x41", 8));  // 8000 x 8001
  std::ofstream(folder_ / "huge.png", std::ios::binary) << huge;
  std::ofstream(folder_ / "text.png") << "no image";
  std::ofstream(folder_ / "nothing.png");
  const ToolRun run =
      find({"--csv", folder_ / "none.png", folder_ / "deep.png", folder_ / "cut_target.png",
            folder_ / "cut_whole.jpg", folder_ / "text.png", folder_ / "nothing.png",
            folder_ / "one.png", folder_ / "huge.png", folder_.path(), "/dev/null",
            folder_ / "whole.jpg"});
  EXPECT_EQ(run.code, 1);
  EXPECT_EQ(split(run.out, '\n').size(), 2u) << run.out;
  for (const char* sentence :
       {"none.png: there is no such file", "deep.png: 16 bits per channel",
        "cut_target.png: the file is truncated", "cut_whole.jpg: the file is truncated",
        "text.png: neither a PNG nor a JPEG", "nothing.png: the file is empty",
        "one.png: an image to search must have at least 16 x 16 pixels",
        "huge.png: the image has more than 64 million pixels", ": a folder; give",
        "/dev/null: not a regular file"})
    EXPECT_TRUE(run.says(sentence)) << sentence << "\n" << run.err;
}

// libjpeg only warns of bytes that are missing, and the rows below are displaced.
TEST_F(FindCommand, DamagedJpegImagesAreRefused) {
  const cv::Mat image = cv::imread(folder_ / "target.png");
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  folder_.write("whole.jpg", image);
  folder_.write("grey.jpg", grey);
  cv::imwrite(folder_ / "progressive.jpg", image, {cv::IMWRITE_JPEG_PROGRESSIVE, 1});
  EXPECT_EQ(find({folder_ / "whole.jpg", folder_ / "grey.jpg", folder_ / "progressive.jpg"}).err,
            "");
  for (const char* name : {"whole.jpg", "grey.jpg", "progressive.jpg"}) {
    const std::string bytes = content_of_file(folder_ / name);
    const std::size_t half = bytes.size() / 2, missing = 600;
    std::ofstream(folder_ / "gap.jpg", std::ios::binary)
        << bytes.substr(0, half) << bytes.substr(half + missing);
    const ToolRun run = find({"--csv", folder_ / "gap.jpg"});
    EXPECT_EQ(run.code, 1) << name;
    EXPECT_TRUE(run.says("gap.jpg: the image is damaged (")) << name << run.err;
    EXPECT_FALSE(run.prints("gap.jpg")) << name;
  }
}

TEST_F(FindCommand, ImagesWithAlphaAndGreyImagesAreSearched) {
  cv::Mat image = cv::imread(folder_ / "target.png"), grey;
  std::vector<cv::Mat> planes;
  cv::split(image, planes);
  grey = planes[1].clone();
  planes.push_back(cv::Mat(image.size(), CV_8UC1, cv::Scalar(7)));
  cv::Mat transparent;
  cv::merge(planes, transparent);
  folder_.write("transparent.png", transparent);
  folder_.write("grey.png", grey);
  const ToolRun run = find({"--csv", folder_ / "transparent.png", folder_ / "grey.png"});
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.prints("transparent.png,part,0,")) << run.out;
}

TEST_F(FindCommand, OverlayShowsTheObjectAndKeepsInputsApart) {
  std::filesystem::create_directory(folder_ / "sub");
  folder_.write("sub/target.png", cv::imread(folder_ / "target.png"));
  const ToolRun run =
      find({"--overlay", folder_ / "marked", folder_ / "target.png", folder_ / "sub/target.png"});
  ASSERT_EQ(run.code, 0) << run.err;
  const cv::Mat marked = cv::imread(folder_ / "marked/target_overlay.png");
  EXPECT_EQ(marked.size(), cv::Size(LessonFolder::kWidth, LessonFolder::kHeight));
  EXPECT_GT(cv::norm(marked, cv::imread(folder_ / "target.png"), cv::NORM_INF), 50);
  EXPECT_FALSE(cv::imread(folder_ / "marked/target_2_overlay.png").empty());
}

TEST_F(FindCommand, AnOverlayReplacesNeitherInputsNorObjects) {
  std::filesystem::create_directory(folder_ / "ov");
  folder_.write("ov/a.png", cv::imread(folder_ / "target.png"));
  folder_.write("ov/a_overlay.png", cv::imread(folder_ / "target.png"));
  const std::string before = content_of_file(folder_ / "ov/a_overlay.png");
  const ToolRun run = find(
      {"--csv", "--overlay", folder_ / "ov", folder_ / "ov/a.png", folder_ / "ov/a_overlay.png"});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says("ov/a_overlay.png: is an input and is not replaced")) << run.err;
  EXPECT_EQ(content_of_file(folder_ / "ov/a_overlay.png"), before);
  EXPECT_TRUE(run.prints("ov/a_overlay.png,part,0,")) << "the input is searched: " << run.out;
  ASSERT_EQ(run_tool(folder_.lesson("target_overlay")).code, 0);
  const ToolRun object = find({"--overlay", folder_.library(), folder_ / "target.png"});
  EXPECT_TRUE(object.says("target_overlay.png: is a learned object")) << object.err;
}

TEST_F(FindCommand, ThresholdsComeFromOptionsAndSettings) {
  const std::string target = folder_ / "target.png";
  EXPECT_TRUE(find({"--min-score", "1", target}).prints("nothing found"));
  EXPECT_TRUE(find({"--set", "min_score=1", target}).prints("nothing found"));
  std::ofstream(folder_ / "settings.yaml") << "min_score: 1\nlibrary_path: unused\n";
  EXPECT_TRUE(find({"--config", folder_ / "settings.yaml", target}).prints("nothing found"));
  const ToolRun both =
      find({"--config", folder_ / "settings.yaml", "--set", "min_score=0.3", target});
  EXPECT_TRUE(both.prints("part at (")) << both.out;
  std::ofstream(folder_ / "wrong.yaml") << "min_scroe: 0.5\n";
  const ToolRun wrong = find({"--config", folder_ / "wrong.yaml", target});
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(wrong.says("did you mean 'min_score'?"));
  const ToolRun missing = find({"--config", folder_ / "none.yaml", target});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(missing.says("none.yaml: there is no such file\n")) << missing.err;
  const ToolRun inside = find({"--config", folder_.path(), target});
  EXPECT_TRUE(inside.says(folder_.path() + ": a folder; give a file")) << inside.err;
}

TEST_F(FindCommand, UnknownNamesAndMissingLibrariesAreRefused) {
  const ToolRun unknown = find({"--name", "nut", folder_ / "target.png"});
  EXPECT_EQ(unknown.code, 1);
  EXPECT_TRUE(unknown.says("no object 'nut'; it has part")) << unknown.err;
  const ToolRun missing = run_tool({"find", "--library", folder_ / "nowhere", "x.png"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(missing.says("no such library folder"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "nowhere"));
  std::filesystem::create_directory(folder_ / "bare");
  EXPECT_TRUE(run_tool({"find", "--library", folder_ / "bare", folder_ / "target.png"})
                  .says("has no objects"));
}

TEST_F(FindCommand, LookAlikesCompeteWithANamedObject) {
  const auto graspable = [&] {
    const ToolRun run = find({"--json", "--name", "part", folder_ / "target.png"});
    EXPECT_FALSE(run.prints("\"twin\"")) << run.out;
    return run.prints("\"graspable\": true");
  };
  EXPECT_TRUE(graspable()) << "without a look-alike";
  ASSERT_EQ(run_tool(folder_.lesson("twin")).code, 0);
  EXPECT_FALSE(graspable());
}

TEST_F(FindCommand, ADisabledObjectIsNamedAsSkipped) {
  ObjectLibrary library(folder_.library());
  library.edit("part", [](ObjectModel& model) { model.enabled = false; });
  const ToolRun run = find({"--json", "--name", "part", folder_ / "target.png"});
  EXPECT_TRUE(run.prints("part: disabled")) << run.out;
  EXPECT_FALSE(find({"--json", folder_ / "target.png"}).prints("disabled"));
}

TEST_F(FindCommand, AnyImageSizeIsSearchedWithAWarning) {
  const cv::Mat image = cv::imread(folder_ / "target.png");
  folder_.write("part_of_it.png", image(cv::Rect(60, 30, 230, 190)));
  const ToolRun run = find({"--csv", folder_ / "part_of_it.png"});
  EXPECT_EQ(run.code, 0);
  EXPECT_TRUE(run.prints("part_of_it.png,part,0,")) << run.out;
  EXPECT_TRUE(run.says("part was learned in images of 320 x 240, this one is 230 x 190"))
      << run.err;
  EXPECT_EQ(find({folder_ / "target.png"}).err, "") << "of the lesson's size";
}

// A JPEG whose orientation says that it should be shown rotated by 90 degrees: coordinates remain
// those of the sensor.
TEST_F(FindCommand, AnExifOrientationIsReportedAndNotApplied) {
  folder_.write("turned.jpg", cv::imread(folder_ / "target.png"));
  std::string bytes = content_of_file(folder_ / "turned.jpg");
  const std::string exif(
      "\xff\xe1\x00\x22"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0\0\0\0\0",
      36);
  bytes.insert(2, exif);
  std::ofstream(folder_ / "turned.jpg", std::ios::binary) << bytes;
  ASSERT_EQ(cv::imread(folder_ / "turned.jpg").cols, LessonFolder::kHeight) << "not read as EXIF";
  const ToolRun run = find({"--csv", folder_ / "turned.jpg"});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_TRUE(run.says("its EXIF orientation (6) is not applied")) << run.err;
  const auto found = split(split(run.out, '\n').at(1), ',');
  EXPECT_NEAR(std::stod(found.at(3)), 195, 1);
  EXPECT_NEAR(std::stod(found.at(4)), 125, 1);
}

}  // namespace
}  // namespace mbncc::test
