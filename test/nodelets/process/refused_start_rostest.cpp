// SPDX-License-Identifier: BSD-3-Clause
// A nodelet that cannot start says why and leaves its manager, which is this process, running.
#include <diagnostic_msgs/DiagnosticArray.h>
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Log.h>

#include <fstream>
#include <string>
#include <vector>

#include "nodelets/spin_until.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

class RefusedStart : public testing::Test {
 protected:
  RefusedStart() {
    log_ = node_.subscribe<rosgraph_msgs::Log>("/rosout", 200,
                                               [this](const rosgraph_msgs::Log::ConstPtr& entry) {
                                                 if (entry->level == rosgraph_msgs::Log::FATAL)
                                                   sentence_ += entry->msg;
                                                 if (entry->level == rosgraph_msgs::Log::ERROR)
                                                   errors_.push_back(entry->msg);
                                               });
  }

  ~RefusedStart() override { ros::param::del("/part"); }

  bool load(const std::string& type) {
    return loader_.load("/part", "mbncc_vision/" + type, {}, {});
  }

  template <class Value>
  void expect_refusal(const std::string& type, const std::string& key, const Value& value,
                      const std::string& named) {
    sentence_.clear();
    ros::param::del("/part");
    ros::param::set("/part/library_path", folder_ / "library");
    if (type.find("Camera") != std::string::npos) ros::param::del("/part/library_path");
    ros::param::set("/part/" + key, value);
    EXPECT_FALSE(load(type)) << type << " " << key;
    EXPECT_TRUE(spin_until([this] { return !sentence_.empty(); })) << type << " " << key;
    EXPECT_NE(sentence_.find(named), std::string::npos) << sentence_;
  }

  test::TemporaryFolder folder_;
  ros::NodeHandle node_;
  ros::Subscriber log_;
  std::string sentence_;
  std::vector<std::string> errors_;
  nodelet::Loader loader_{false};
};

TEST_F(RefusedStart, UnknownParameter) {
  for (const char* type :
       {"CameraNodelet", "SimulatedCameraNodelet", "LearningNodelet", "MatchingNodelet"})
    expect_refusal(type, "no_such_parameter", 1, "'no_such_parameter'");
}

TEST_F(RefusedStart, ValueOutOfRange) {
  expect_refusal("SimulatedCameraNodelet", "gain", 1000.0, "0.05 .. 4");
  expect_refusal("LearningNodelet", "still_time", -1.0, "'still_time'");
  expect_refusal("LearningNodelet", "cell_name", std::string(201, 'x'), "'cell_name'");
  expect_refusal("MatchingNodelet", "min_score", 7, "/part: parameter 'min_score': value '7'");
  expect_refusal("MatchingNodelet", "min_score", 7, "0 .. 1");
  expect_refusal("MatchingNodelet", "confirm_frames", 9,
                 "/part: parameter 'confirm_frames': value '9' is not allowed; give 1 .. "
                 "confirm_window, which is 5");
}

TEST_F(RefusedStart, IntrinsicsThatCannotBeRead) {
  for (const char* type : {"LearningNodelet", "MatchingNodelet"})
    expect_refusal(type, "platform_intrinsics", "plumb_bob 640 480", "calibrate_platform");
}

TEST_F(RefusedStart, SceneThatCannotBeDrawn) {
  expect_refusal("SimulatedCameraNodelet", "object_diameter", 600.0, "do not fit");
}

TEST_F(RefusedStart, LibraryThatCannotBeOpened) {
  const std::string file = folder_ / "file";
  std::ofstream(file) << "no folder";
  for (const char* type : {"LearningNodelet", "MatchingNodelet"})
    expect_refusal(type, "library_path", file + "/library", file);
}

// roslaunch would restart such a nodelet again and again.
TEST_F(RefusedStart, MissingImageTransportIsReportedOnceAndInDiagnostics) {
  for (const char* type : {"LearningNodelet", "MatchingNodelet"}) {
    errors_.clear();
    ros::param::set("/part/library_path", folder_ / "library");
    ros::param::set("/part/image_transport", "pigeon");
    int reports = 0;
    const auto diagnostics = node_.subscribe<diagnostic_msgs::DiagnosticArray>(
        "/diagnostics", 10, [&](const diagnostic_msgs::DiagnosticArray::ConstPtr& array) {
          for (const auto& status : array->status)
            if (status.level == diagnostic_msgs::DiagnosticStatus::ERROR &&
                status.message.find("pigeon_image_transport") != std::string::npos)
              ++reports;
        });
    ASSERT_TRUE(load(type)) << type;
    EXPECT_TRUE(spin_until([&] { return reports >= 3 && !errors_.empty(); })) << type;
    ASSERT_EQ(errors_.size(), 1u) << type;
    EXPECT_NE(errors_[0].find("set image_transport to raw"), std::string::npos) << errors_[0];
    EXPECT_TRUE(loader_.unload("/part"));
  }
}

TEST_F(RefusedStart, StaleStatusNamesTheImageTransport) {
  ros::param::set("/part/library_path", folder_ / "library");
  ros::param::set("/part/image_transport", "pigeon");
  std::string message;
  const auto detections = node_.subscribe<mbncc_vision::DetectedObjectArray>(
      "detected_objects", 10, [&](const mbncc_vision::DetectedObjectArray::ConstPtr& array) {
        if (array->status == array->STALE) message = array->message;
      });
  ASSERT_TRUE(load("MatchingNodelet"));
  EXPECT_TRUE(spin_until([&] { return message.find("pigeon") != std::string::npos; })) << message;
  EXPECT_TRUE(loader_.unload("/part"));
}

TEST_F(RefusedStart, CorrectedParametersAllowTheStart) {
  expect_refusal("LearningNodelet", "still_time", -1.0, "'still_time'");
  ros::param::set("/part/still_time", 0.5);
  EXPECT_TRUE(load("LearningNodelet"));
  EXPECT_TRUE(loader_.unload("/part"));
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "refused_start_rostest");
  // Between tests, no other handle exists, and the node would shut down.
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
