// SPDX-License-Identifier: BSD-3-Clause
// All nodelets in one process, fed at full rate: teaching, edits, find_objects and changing
// camera_infos alongside matching, more images than can be searched, a long run. MBNCC_SOAK_FRAMES
// and MBNCC_SOAK_MINUTES: searched images and duration of the long run, whichever is reached later;
// MBNCC_SOAK_CSV: a file for memory, open files and threads over time.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/FindObjects.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "mbncc/sim/scene.hpp"
#include "nodelets/call_service.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"
#include "support/process_state.hpp"
#include "support/sanitizers.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObjectArray;
using test::StateHistory;

// One leaked image per lesson would add ten times as much.
constexpr double kMostGrowthInUse = 2;  // [MB]
constexpr double kMostGrowth = 5;       // [MB]
// roscpp keeps connections to the XML-RPC servers of other nodes for 30 s (XMLRPCManager), which is
// about as long as the run, so a few more may be open at its end. A leak in lessons or edits would
// add hundreds.
constexpr int kMostNewFiles = 3;
constexpr std::chrono::hours kPatience{24};

long number(const char* variable, long otherwise) {
  const char* text = std::getenv(variable);
  return text == nullptr ? otherwise : std::atol(text);
}

std::string soak_csv() {
  const char* text = std::getenv("MBNCC_SOAK_CSV");
  return text == nullptr ? "" : text;
}

double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

class Soak : public testing::Test {
 protected:
  Soak() {
    set("/learning/library_path", folder_ / "library");
    set("/matching/library_path", folder_ / "library");
    set("/matching/platform_distance", 0.5);
    set("/matching/max_age", 10.0);  // a busy machine may search late
    use_size({160, 120});
    set("/camera/object_diameter", 40.0);
    set("/camera/neighbours", 0);
    set("/camera/frame_rate", 120.0);
    set("/camera/rest_time", 1.0);
    set("/camera/leg_time", 0.3);
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 1000, [this](const DetectedObjectArray::ConstPtr& array) {
          if (array->status == DetectedObjectArray::STALE) return;
          EXPECT_GT(array->header.stamp, last_stamp_) << "an older image after a newer one";
          last_stamp_ = array->header.stamp;
          latencies_.push_back(array->latency);
          costs_.push_back(array->search_time);
          ++searched_;
        });
  }

  ~Soak() override {
    for (const char* name : {"/camera", "/learning", "/matching"}) ros::param::del(name);
  }

  template <class Value>
  void set(const std::string& key, const Value& value) {
    ros::param::set(key, value);
  }

  void load(const std::string& name, const std::string& type) {
    ASSERT_TRUE(loader_.load(name, "mbncc_vision/" + type, {}, {})) << name;
  }

  /// Runs lessons with given images one after the other, together with the edits and reloads of the
  /// nodelet.
  void keep_teaching(Teacher& teacher) {
    if (!lesson_.empty() && !teacher.ended(lesson_)) return;
    if (!lesson_.empty()) {
      teacher.forget(lesson_);
      ++lessons_;
      edit();
      ask();
    }
    Teacher::Goal goal;
    goal.name = "part";
    goal.overwrite = true;
    goal.before = before_;
    goal.after = after_;
    lesson_ = teacher.send(goal);
  }

  void edit() {
    using Edit = mbncc_vision::EditObject;
    constexpr std::uint8_t kCommands[] = {Edit::Request::SET_THRESHOLD, Edit::Request::DISABLE,
                                          Edit::Request::ENABLE};
    Edit call;
    call.request.name = "part";
    call.request.command = kCommands[lessons_ % 3];
    call.request.min_score = 0.4F;
    if (call_service("edit_object", call) && call.response.success) ++edits_;
  }

  /// Searches a given image while the camera publishes another calibration.
  void ask() {
    mbncc_vision::FindObjects call;
    call.request.image = before_;
    if (call_service("find_objects", call) && call.response.success) ++answers_;
    const double focal = before_.width * (0.8 + 0.1 * static_cast<double>(lessons_ % 5));
    sensor_msgs::CameraInfo info;
    info.header.frame_id = "camera_optical_frame";
    info.header.stamp = ros::Time::now();
    info.width = before_.width;
    info.height = before_.height;
    info.distortion_model = "plumb_bob";
    info.D.resize(5);
    info.K = {focal, 0, before_.width / 2.0, 0, focal, before_.height / 2.0, 0, 0, 1};
    info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    info.P = {focal, 0, info.K[2], 0, 0, focal, info.K[5], 0, 0, 0, 1, 0};
    infos_.publish(info);
  }

  /// Uses images of this size for teaching and showing.
  void use_size(const cv::Size& size) {
    set("/camera/width", size.width);
    set("/camera/height", size.height);
    sim::SceneConfig config;
    config.size = size;
    const sim::Scene scene(config);
    const sim::Placed part{{11, size.height / 2.0, 1.6},
                           {size.width / 2.0, size.height / 2.0, 0.2}};
    before_ = encode_image(scene.render({part}, 1));
    after_ = encode_image(scene.render({}, 2));
  }

  void record(const std::string& what) {
    for (const double part : {0.5, 0.95, 0.99})
      RecordProperty(what + "_latency_p" + std::to_string(static_cast<int>(100 * part)) + "_ms",
                     std::to_string(1000 * percentile(latencies_, part)));
    RecordProperty(what + "_search_p50_ms", std::to_string(1000 * percentile(costs_, 0.5)));
    RecordProperty(what + "_search_p99_ms", std::to_string(1000 * percentile(costs_, 0.99)));
    latencies_.clear();
    costs_.clear();
  }

  const test::TemporaryFolder folder_;
  ros::NodeHandle node_;
  ros::Subscriber detections_;
  ros::Publisher infos_ = node_.advertise<sensor_msgs::CameraInfo>("camera_info", 1);
  sensor_msgs::Image before_, after_;
  ros::Time last_stamp_;
  std::vector<double> latencies_, costs_;  // [s]
  long searched_ = 0, lessons_ = 0, edits_ = 0, answers_ = 0;
  std::string lesson_;
  nodelet::Loader loader_{false};
};

TEST_F(Soak, TeachingWhileMatchingKeepsTheMemoryConstant) {
  if (!test::process_is_visible()) GTEST_SKIP() << "/proc is not mounted";
  load("/camera", "SimulatedCameraNodelet");
  load("/rectify", "RectifyNodelet");
  load("/matching", "MatchingNodelet");
  load("/learning", "LearningNodelet");
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  int looked = 0;
  const auto look = [&looked](const sensor_msgs::ImageConstPtr&) { ++looked; };
  const ros::Subscriber rectified = node_.subscribe<sensor_msgs::Image>("image_rect", 1, look);
  const ros::Subscriber overlay = node_.subscribe<sensor_msgs::Image>("matching/overlay", 1, look);
  const long frames = number("MBNCC_SOAK_FRAMES", 2000), every = std::max(1L, frames / 400);
  StateHistory history(soak_csv());
  const auto end =
      std::chrono::steady_clock::now() + std::chrono::minutes(number("MBNCC_SOAK_MINUTES", 0));
  long sampled = 0;
  ASSERT_TRUE(spin_until(
      [&] {
        keep_teaching(teacher);
        for (; searched_ >= sampled; sampled += every) history.add(sampled);
        // The figures of a long run would only use up memory.
        if (latencies_.size() > 20000) record("full_rate");
        return searched_ >= frames && std::chrono::steady_clock::now() >= end;
      },
      kPatience));
  if (!latencies_.empty()) record("full_rate");
  RecordProperty("lessons", std::to_string(lessons_));
  RecordProperty("growth_mb", std::to_string(history.growth()));
  RecordProperty("growth_in_use_mb", std::to_string(history.growth_in_use()));
  RecordProperty("edits", std::to_string(edits_));
  RecordProperty("answers", std::to_string(answers_));
  EXPECT_GT(edits_, 0);
  EXPECT_GT(answers_, 0);
  EXPECT_GT(looked, 0);
  EXPECT_LT(history.growth_in_use(), kMostGrowthInUse);
  if (!test::kSanitized) {
    EXPECT_LT(history.growth(), kMostGrowth);
  }
  EXPECT_LE(history.new_files(), kMostNewFiles);
  EXPECT_GT(lessons_, 2 * kMostNewFiles);
  EXPECT_LE(history.new_threads(), 0);
}

// 60 images per second, each of which takes about a fifth of a second to search completely.
TEST_F(Soak, OverloadSearchesTheNewestImageAndQueuesNone) {
  if (!test::process_is_visible()) GTEST_SKIP() << "/proc is not mounted";
  constexpr int kSearched = 40;
  use_size({1280, 960});
  set("/camera/frame_rate", 60.0);
  set("/matching/sweep_time", 0.0);
  set("/matching/scale_range", 0.5);
  load("/learning", "LearningNodelet");
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  keep_teaching(teacher);
  ASSERT_EQ(teacher.await(lesson_).result.error_code, Teacher::Result::SUCCESS);
  load("/camera", "SimulatedCameraNodelet");
  load("/matching", "MatchingNodelet");
  int published = 0;
  const ros::Subscriber images = node_.subscribe<sensor_msgs::Image>(
      "image_raw", 1000, [&](const sensor_msgs::ImageConstPtr&) { ++published; });
  StateHistory history;
  ASSERT_TRUE(spin_until(
      [&] {
        history.add(searched_);
        return searched_ >= kSearched;
      },
      std::chrono::minutes(3)));
  record("overload");
  RecordProperty("published", published);
  RecordProperty("searched", static_cast<int>(searched_));
  EXPECT_GE(published, searched_);
  EXPECT_LE(history.new_threads(), 0);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "soak_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
