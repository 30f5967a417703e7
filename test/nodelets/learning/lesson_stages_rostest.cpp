// SPDX-License-Identifier: BSD-3-Clause
// Cancels a lesson and unloads the learning nodelet in every stage. The nodelet runs in this
// process, so that sanitizers check it. MBNCC_ROUNDS: number of repetitions; the slowest one is
// written to the test's report.
#include <gtest/gtest.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "mbncc/sim/scene.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using actionlib_msgs::GoalStatus;
using Feedback = Teacher::Feedback;
using Result = Teacher::Result;

int rounds() {
  const char* text = std::getenv("MBNCC_ROUNDS");
  return text == nullptr ? 2 : std::atoi(text);
}

sim::SceneConfig scene_config() {
  sim::SceneConfig config;
  config.size = {640, 480};
  return config;
}

/// What the camera shows.
enum class Show { kNothing, kStill, kMotion, kTurned, kTurnedEmpty };

/// One stage, and how to get a lesson into it.
struct Way {
  const char* name;
  std::uint8_t stage;
  Show show;
  bool given;    // both images are given with the goal
  bool confirm;  // the operator is asked
  bool waits;    // the lesson stays in the stage by itself
};

const Way kWays[] = {
    {"WAIT_IMAGE", Feedback::WAIT_IMAGE, Show::kNothing, false, false, true},
    {"WAIT_REMOVAL", Feedback::WAIT_REMOVAL, Show::kStill, false, false, true},
    {"WAIT_STILL", Feedback::WAIT_STILL, Show::kMotion, false, false, true},
    {"REGION", Feedback::REGION, Show::kNothing, true, false, false},
    {"SEGMENT", Feedback::SEGMENT, Show::kNothing, true, false, false},
    {"QUALITY", Feedback::QUALITY, Show::kNothing, true, false, false},
    {"WAIT_CONFIRM", Feedback::WAIT_CONFIRM, Show::kNothing, true, true, true},
    {"STORE", Feedback::STORE, Show::kNothing, true, false, false},
};

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

class LessonStages : public testing::TestWithParam<Way> {
 protected:
  LessonStages() {
    images_ = node_.advertise<sensor_msgs::Image>("image_raw", 1);
    camera_ = node_.createWallTimer(ros::WallDuration(0.05), [this](const auto&) { publish(); });
    ros::param::set("/learning/library_path", folder_ / "library");
    ros::param::set("/learning/still_time", 0.2);
  }

  void publish() {
    if (show_ == Show::kNothing) return;
    std_msgs::Header header;
    header.stamp = ros::Time::now();
    header.frame_id = "camera";
    images_.publish(encode_image(image(), header));
  }

  cv::Mat image() {
    if (show_ == Show::kTurned) return turned(before_);
    if (show_ == Show::kTurnedEmpty) return turned(after_);
    // The motion begins once the lesson has seen the scene before.
    const bool moves = show_ == Show::kMotion && has_asked_;
    return moves && ++shown_ % 2 == 0 ? moving_ : before_;
  }

  /// The image after someone has bumped into the camera.
  static cv::Mat turned(const cv::Mat& image) {
    cv::Mat result;
    const cv::Mat motion = cv::getRotationMatrix2D({image.cols / 2.f, image.rows / 2.f}, -3, 1);
    cv::warpAffine(image, result, motion, image.size(), cv::INTER_CUBIC, cv::BORDER_REFLECT);
    return result;
  }

  void load() {
    loader_ = std::make_unique<nodelet::Loader>(false);
    ASSERT_TRUE(loader_->load("/learning", "mbncc_vision/LearningNodelet", {}, {}));
    teacher_ = std::make_unique<Teacher>();
    ASSERT_TRUE(teacher_->connect());
  }

  /// Starts a lesson and returns its id when it has reached the stage.
  std::string reach_stage(const Way& way) {
    show_ = way.show;
    has_asked_ = false;
    Teacher::Goal goal;
    goal.name = "part";
    goal.overwrite = true;
    goal.confirm = way.confirm;
    if (way.given) {
      goal.before = encode_image(before_);
      goal.after = encode_image(after_);
    }
    const std::string id = teacher_->send(goal);
    EXPECT_TRUE(spin_until([&] {
      has_asked_ = has_asked_ || teacher_->has_been_in(id, Feedback::WAIT_REMOVAL);
      return teacher_->has_been_in(id, way.stage);
    })) << way.name;
    return id;
  }

  bool is_stored() const { return std::filesystem::exists(folder_ / "library/part.png"); }

  /// Nothing is stored after "cancelled", and a lesson that waits cannot have succeeded in the
  /// meantime.
  void expect_end(const Way& way, const std::string& id, std::uint8_t status) {
    const auto end = teacher_->await(id);
    if (end.result.error_code == Result::SUCCESS) {
      EXPECT_FALSE(way.waits) << way.name;
      EXPECT_TRUE(is_stored());
      std::filesystem::remove(folder_ / "library/part.png");
      return;
    }
    EXPECT_EQ(end.result.error_code, Result::CANCELLED) << way.name << end.result.message;
    EXPECT_EQ(end.status.status, status) << way.name;
    EXPECT_FALSE(is_stored()) << way.name;
    ++cancelled_;
  }

  const test::TemporaryFolder folder_;
  const sim::Scene scene_{scene_config()};
  const sim::Placed part_{{11, 120, 1.6}, {320.2, 240.4, 0.3}};
  const cv::Mat before_ = scene_.render({part_}, 1), after_ = scene_.render({}, 2);
  const cv::Mat moving_ = scene_.render({part_}, 3, sim::Arm{{320, 240, -1.57}, 60});
  Show show_ = Show::kNothing;
  bool has_asked_ = false;
  int shown_ = 0, cancelled_ = 0;
  double slowest_ = 0;  // [s]
  ros::NodeHandle node_;
  ros::Publisher images_;
  ros::WallTimer camera_;
  std::unique_ptr<nodelet::Loader> loader_;
  std::unique_ptr<Teacher> teacher_;
};

TEST_P(LessonStages, CancellingKeepsTheLibrary) {
  const Way way = GetParam();
  load();
  for (int round = 0; round < rounds(); ++round) {
    const std::string id = reach_stage(way);
    const auto start = std::chrono::steady_clock::now();
    teacher_->cancel(id);
    expect_end(way, id, GoalStatus::PREEMPTED);
    slowest_ = std::max(slowest_, seconds_since(start));
  }
  RecordProperty("cancelled", cancelled_);
  RecordProperty("slowest_ms", static_cast<int>(1000 * slowest_));
}

TEST_P(LessonStages, UnloadingInformsTheClientAndKeepsTheLibrary) {
  const Way way = GetParam();
  for (int round = 0; round < rounds(); ++round) {
    load();
    const std::string id = reach_stage(way);
    const auto start = std::chrono::steady_clock::now();
    ASSERT_TRUE(loader_->unload("/learning"));
    slowest_ = std::max(slowest_, seconds_since(start));
    expect_end(way, id, GoalStatus::ABORTED);
  }
  RecordProperty("cancelled", cancelled_);
  RecordProperty("slowest_ms", static_cast<int>(1000 * slowest_));
}

using LessonCamera = LessonStages;

// Otherwise the lesson would report forever that something reaches over the edge.
TEST_P(LessonCamera, MotionIsReportedAndTheLessonContinues) {
  load();
  const std::string id = reach_stage(kWays[1]);
  show_ = Show::kTurned;
  EXPECT_TRUE(spin_until([&] {
    return teacher_->last_feedback(id).message.find("The camera has moved; the lesson continues") ==
           0;
  })) << teacher_->last_feedback(id).message;
  show_ = Show::kTurnedEmpty;
  EXPECT_EQ(teacher_->await(id).result.error_code, Result::SUCCESS);
}

INSTANTIATE_TEST_SUITE_P(Any, LessonCamera, testing::Values(kWays[0]));

using LessonSearch = LessonStages;

// The object is found again with a score below 1, so such a search would not report it.
TEST_P(LessonSearch, UsesTheConfiguredSearch) {
  const auto verdict = [this] {
    load();
    Teacher::Goal goal;
    goal.name = "part";
    goal.overwrite = true;
    goal.before = encode_image(before_);
    goal.after = encode_image(after_);
    return teacher_->teach(goal).error_code;
  };
  EXPECT_EQ(verdict(), Result::SUCCESS);
  ros::param::set("/learning/matching/min_score", 1.0);
  ros::param::set("/learning/matching/confirm_score", 1.0);
  EXPECT_EQ(verdict(), Result::NOT_DISTINCT);
  ros::param::set("/learning/matching/min_score", 7.0);
  loader_ = std::make_unique<nodelet::Loader>(false);
  EXPECT_FALSE(loader_->load("/learning", "mbncc_vision/LearningNodelet", {}, {}))
      << "nonsense is refused there, too";
  ros::param::del("/learning/matching");
}

INSTANTIATE_TEST_SUITE_P(Any, LessonSearch, testing::Values(kWays[0]));

INSTANTIATE_TEST_SUITE_P(All, LessonStages, testing::ValuesIn(kWays),
                         [](const auto& way) { return way.param.name; });

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "lesson_stages_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
