// SPDX-License-Identifier: BSD-3-Clause
// Tests of the commands map, list, show, forget, restore, check and params.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "cli/tool.hpp"
#include "mbncc/config/camera_config.hpp"
#include "mbncc/config/learning_node_config.hpp"
#include "mbncc/config/matching_node_config.hpp"
#include "mbncc/config/rectify_config.hpp"
#include "mbncc/config/simulated_camera_config.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/settled_file.hpp"

namespace mbncc::test {
namespace {

class LibraryCommands : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(run_tool(folder_.lesson("part")).code, 0); }

  ToolRun on_library(const std::string& command, const std::vector<std::string>& words = {}) const {
    return run_tool(std::vector<std::string>{command, "--library", folder_.library()} + words);
  }

  void damage(const std::string& name) const {
    const std::string file = folder_.library() + "/" + name + ".png";
    std::ofstream(file) << "no image";
    settle(file);
  }

  LessonFolder folder_;
};

TEST_F(LibraryCommands, TheMapIsExportedAtFullSize) {
  ASSERT_EQ(on_library("map", {"--name", "part", "--out", folder_ / "out.png"}).code, 0);
  const cv::Mat out = cv::imread(folder_ / "out.png", cv::IMREAD_UNCHANGED);
  const cv::Mat map = cv::imread(folder_ / "map.png", cv::IMREAD_UNCHANGED);
  ASSERT_EQ(out.type(), CV_8UC1);
  ASSERT_EQ(out.size(), map.size());
  EXPECT_EQ(cv::norm(out, map, cv::NORM_INF), 0);
  const ToolRun nowhere = on_library("map", {"--name", "part", "--out", folder_ / "no/out.png"});
  EXPECT_EQ(nowhere.code, 1);
  EXPECT_TRUE(nowhere.says("cannot be written: No such file or directory; create the folder"))
      << nowhere.err;
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out.png.part"));
  const ToolRun full = on_library("map", {"--name", "part", "--out", "/dev/full"});
  EXPECT_EQ(full.code, 1);
  EXPECT_TRUE(full.says("No space left on device")) << full.err;
}

TEST_F(LibraryCommands, AnObjectIsNotReplacedByAnImage) {
  const std::string object = folder_.library() + "/part.png";
  const std::string stored = content_of_file(object);
  ASSERT_EQ(run_tool(folder_.lesson("before")).code, 0);
  for (const ToolRun& run :
       {on_library("map", {"--name", "part", "--out", object}),
        on_library("explain", {"--at", "195,125", "--overlay", object, folder_ / "target.png"}),
        on_library("explain", {"--at", "195,125", "--save", object, folder_ / "target.png"}),
        run_tool({"simulate", "--out", folder_.library(), "--count", "1"})}) {
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(run.says(".png: is a learned object and is not replaced")) << run.err;
  }
  EXPECT_EQ(content_of_file(object), stored);
  const std::string map = folder_ / "map.png";
  EXPECT_EQ(on_library("map", {"--name", "part", "--out", map}).code, 0) << "an image is replaced";
}

TEST_F(LibraryCommands, WithoutHomeNoFolderNamedTildeIsMade) {
  const char* home = std::getenv("HOME");
  const std::string kept = home == nullptr ? "" : home;
  ::unsetenv("HOME");
  const ToolRun run = run_tool({"list"});
  ::setenv("HOME", folder_.path().c_str(), 1);
  const ToolRun at_home = run_tool({"list", "--set", "library_path=~/library"});
  ::setenv("HOME", kept.c_str(), 1);
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(run.says("HOME is not set; give --library")) << run.err;
  EXPECT_TRUE(at_home.prints("part")) << at_home.err;
}

TEST_F(LibraryCommands, ListAndShowDescribeObjects) {
  EXPECT_TRUE(on_library("list").prints("part"));
  EXPECT_TRUE(on_library("list").prints("none (auto)")) << "nothing is declared";
  ASSERT_EQ(run_tool(folder_.lesson("twin")).code, 0);
  const auto lines = split(on_library("list", {"--json"}).out, '\n');
  ASSERT_EQ(lines.size(), 2u) << "one object a line";
  EXPECT_EQ(YAML::Load(lines[0])["name"].as<std::string>(), "part");
  EXPECT_EQ(YAML::Load(lines[1])["name"].as<std::string>(), "twin");
  EXPECT_TRUE(on_library("show", {"--name", "part"}).prints("verdict"));
  const YAML::Node object = YAML::Load(on_library("show", {"--name", "part", "--json"}).out);
  EXPECT_EQ(object["views"].size(), 1u);
  EXPECT_TRUE(object["quality"]["verdict"]);
  EXPECT_EQ(on_library("show", {"--name", "nut"}).code, 1);
}

TEST_F(LibraryCommands, TheCellThatTaughtAnObjectIsShown) {
  EXPECT_EQ(on_library("show", {"--name", "part"}).out.find(" by "), std::string::npos);
  ObjectLibrary(folder_.library()).edit("part", [](ObjectModel& object) {
    object.taught_by = "robot7/left";
  });
  EXPECT_TRUE(on_library("show", {"--name", "part"}).prints(" by robot7/left, enabled"));
  const YAML::Node object = YAML::Load(on_library("show", {"--name", "part", "--json"}).out);
  EXPECT_EQ(object["taught_by"].as<std::string>(), "robot7/left");
}

TEST_F(LibraryCommands, ASymmetryIsDeclaredAndShown) {
  const auto shown = [this] { return on_library("show", {"--name", "part"}).out; };
  EXPECT_NE(shown().find("symmetry none, as measured"), std::string::npos) << shown();
  const ToolRun edit = on_library("edit", {"--name", "part", "--symmetry", "round"});
  EXPECT_EQ(edit.code, 0) << edit.err;
  EXPECT_TRUE(edit.prints("'part' has symmetry round, revision 2")) << edit.out;
  const ToolRun strict = on_library("edit", {"--name", "part", "--min-score", "0.75"});
  EXPECT_TRUE(strict.prints("'part' has symmetry round, is reported at a score of 0.75 or more"))
      << strict.out;
  EXPECT_TRUE(strict.prints(", revision 2\n")) << "a threshold is no new revision: " << strict.out;
  const ToolRun usual = on_library("edit", {"--name", "part", "--min-score", "auto"});
  EXPECT_FALSE(usual.prints("is reported at")) << usual.out;
  EXPECT_EQ(on_library("edit", {"--name", "part"}).code, 2) << "nothing to do";
  EXPECT_EQ(on_library("edit", {"--name", "part", "--min-score", "0"}).code, 2);
  EXPECT_NE(shown().find("symmetry round, declared"), std::string::npos) << shown();
  EXPECT_TRUE(on_library("list").prints("round"));
  const YAML::Node list = YAML::Load(on_library("list", {"--json"}).out);
  EXPECT_EQ(list["symmetry"].as<std::string>(), "round");
  EXPECT_EQ(on_library("edit", {"--name", "nut", "--symmetry", "2"}).code, 1);
  EXPECT_EQ(on_library("edit", {"--name", "part", "--symmetry", "auto"}).code, 0);
  EXPECT_NE(shown().find("symmetry none, as measured"), std::string::npos) << shown();
}

TEST_F(LibraryCommands, ForgottenObjectsCanBeRestored) {
  EXPECT_EQ(on_library("forget", {"--name", "part"}).code, 0);
  EXPECT_FALSE(on_library("list").prints("part"));
  const ToolRun again = on_library("forget", {"--name", "part"});
  EXPECT_EQ(again.code, 1);
  EXPECT_TRUE(again.says("no object 'part'")) << again.err;
  const ToolRun missing = on_library("restore", {"--name", "part", "--revision", "9"});
  EXPECT_EQ(missing.code, 1);
  EXPECT_TRUE(missing.says("no revision 9 of 'part'; it has 1")) << missing.err;
  EXPECT_TRUE(on_library("restore", {"--name", "part"}).prints("as revision 2"));
  EXPECT_TRUE(on_library("list").prints("part"));
}

TEST_F(LibraryCommands, CheckReportsUnreadableFilesUntilTheyAreGone) {
  EXPECT_EQ(on_library("check").code, 0);
  damage("broken");
  for (int round = 0; round < 2; ++round) {
    const ToolRun check = on_library("check");
    EXPECT_EQ(check.code, 1);
    EXPECT_TRUE(check.prints("1 readable, 1 unreadable")) << check.out;
    EXPECT_TRUE(check.says(".quarantine/broken.png: ")) << check.err;
  }
  std::filesystem::remove_all(folder_.library() + "/.quarantine");
  EXPECT_EQ(on_library("check").code, 0);
}

TEST_F(LibraryCommands, CheckRepairsFromTheTrashAndReportsIt) {
  ASSERT_EQ(run_tool(folder_.lesson("part") + std::vector<std::string>{"--overwrite"}).code, 0);
  for (const char* name : {"part", "stranger"}) damage(name);
  const ToolRun check = on_library("check", {"--repair"});
  EXPECT_EQ(check.code, 1) << "the quarantine is not empty";
  EXPECT_TRUE(check.prints("brought 'part' from the trash as revision 3")) << check.out;
  EXPECT_TRUE(check.prints("1 readable, 2 unreadable")) << check.out;
  EXPECT_TRUE(check.says("'stranger' cannot be restored: ")) << check.err;
  EXPECT_TRUE(on_library("list").prints("part"));
  EXPECT_FALSE(on_library("check", {"--repair"}).prints("brought")) << "once is enough";
  std::filesystem::remove_all(folder_.library() + "/.quarantine");
  EXPECT_EQ(on_library("check").code, 0);
}

TEST_F(LibraryCommands, CheckDoesNotBringBackWhatWasDeletedSince) {
  ASSERT_EQ(run_tool(folder_.lesson("part") + std::vector<std::string>{"--overwrite"}).code, 0);
  damage("part");
  ASSERT_TRUE(on_library("check", {"--repair"}).prints("brought 'part'"));
  ASSERT_EQ(on_library("forget", {"--name", "part"}).code, 0);
  const ToolRun check = on_library("check", {"--repair"});
  EXPECT_FALSE(check.prints("brought")) << check.out;
  EXPECT_TRUE(check.prints("0 readable, 1 unreadable")) << check.out;
}

TEST_F(LibraryCommands, RestoreErrorNamesTheTrashFolder) {
  const ToolRun run = on_library("restore", {"--name", "nosuch"});
  EXPECT_EQ(run.code, 1);
  EXPECT_TRUE(
      run.says("no object 'nosuch'; its objects are the files of " + folder_.library() + "/.trash"))
      << run.err;
}

TEST_F(LibraryCommands, ImagesOfTheUserStayWhereTheyAre) {
  std::filesystem::create_directory(folder_ / "photos");
  folder_.write("photos/target.png", cv::imread(folder_ / "target.png"));
  const std::string photo = folder_ / "photos/target.png";
  for (const std::string command : {"list", "find"}) {
    const ToolRun run =
        run_tool(std::vector<std::string>{command, "--library", folder_ / "photos"} +
                 std::vector<std::string>(command == "find" ? 1 : 0, photo));
    EXPECT_EQ(run.code, 1);
    EXPECT_TRUE(run.says("the library has no objects; teach one first")) << run.err;
    EXPECT_EQ(run.err.find(photo + ": not an object; left in place\n"),
              run.err.rfind("not an object") - photo.size() - 2)
        << "once: " << run.err;
  }
  EXPECT_TRUE(std::filesystem::exists(photo));
  folder_.write("library/photo.png", cv::imread(folder_ / "target.png"));
  const ToolRun check = on_library("check");
  EXPECT_EQ(check.code, 0) << check.err;
  EXPECT_TRUE(check.says("photo.png: not an object; left in place")) << check.err;
  const ToolRun lesson = run_tool(folder_.lesson("photo"));
  EXPECT_EQ(lesson.code, 1);
  EXPECT_TRUE(lesson.says("An image that is not an object has this name")) << lesson.err;
}

TEST_F(LibraryCommands, CommandsWarnOfOtherUnreadableFiles) {
  damage("broken");
  const ToolRun list = on_library("list");
  EXPECT_EQ(list.code, 0);
  EXPECT_TRUE(list.says("broken.png")) << list.err;
}

TEST(ParamsCommand, ListsEveryFieldOfEveryStruct) {
  const ToolRun plain = run_tool({"params"}), markdown = run_tool({"params", "--markdown"});
  ASSERT_EQ(plain.code, 0);
  ASSERT_EQ(markdown.code, 0);
  const auto expect_all = [&](auto config) {
    for (const auto& row : field_rows(config)) {
      EXPECT_TRUE(plain.prints("\n" + row.info.name + " ")) << row.info.name;
      EXPECT_TRUE(markdown.prints("\n| " + row.info.name + " | ")) << row.info.name;
    }
  };
  expect_all(MatchingNodeConfig{});
  expect_all(LearningNodeConfig{});
  expect_all(CameraConfig{});
  expect_all(RectifyConfig{});
  expect_all(SimulatedCameraConfig{});
  EXPECT_TRUE(run_tool({"params", "--set", "min_score=0.125"}).prints("0.125"));
}

}  // namespace
}  // namespace mbncc::test
