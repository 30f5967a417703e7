// SPDX-License-Identifier: BSD-3-Clause
// A session with simulated clock and images: identities, accepted stamps, and the example consumer.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/FindObjects.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <future>
#include <vector>

#include "nodelets/call_service.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/drawn_images.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

const ros::Duration kInterval(1. / 30);

sim::Placed placed_at(const Pose2D& pose) {
  return drawn_part(60, pose);
}

class Session : public testing::Test {
 protected:
  Session() {
    clock_ = node_.advertise<rosgraph_msgs::Clock>("/clock", 1);
    images_ = node_.advertise<sensor_msgs::Image>("image_raw", 5);
    infos_ = node_.advertise<sensor_msgs::CameraInfo>("camera_info", 5);
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 100,
        [this](const DetectedObjectArray::ConstPtr& array) { arrays_.push_back(array); });
  }

  void SetUp() override {
    ASSERT_TRUE(ros::service::waitForService("find_objects", ros::Duration(-1)));
    set_clock(ros::Time(start_ += 1000));
    ASSERT_TRUE(spin_until([this] {
      set_clock(now_);
      return ros::Time::now() == now_ && images_.getNumSubscribers() > 0 &&
             detections_.getNumPublishers() > 0;
    }));
    teach();
  }

  void set_clock(const ros::Time& now) {
    now_ = now;
    rosgraph_msgs::Clock clock;
    clock.clock = now;
    clock_.publish(clock);
  }

  void teach() {
    if (taught_) return;
    Teacher teacher;
    ASSERT_TRUE(teacher.connect());
    Teacher::Goal goal;
    goal.name = "part";
    goal.before = encode_image(scene_.render({placed_at({200.3, 150.6, 0})}, 1));
    goal.after = encode_image(scene_.render({}, 2));
    const auto lesson = teacher.teach(goal);
    ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
    ASSERT_TRUE(spin_until([] {
      mbncc_vision::FindObjects find;
      find.request.image = encode_image(cv::Mat(300, 400, CV_8UC3, cv::Scalar::all(90)));
      return call_service("find_objects", find) && find.response.success &&
             !find.response.detections.searched.empty();
    }));
    taught_ = true;
  }

  void publish(const std::vector<Pose2D>& poses, const ros::Time& stamp) {
    std::vector<sim::Placed> placed;
    for (const auto& pose : poses) placed.push_back(placed_at(pose));
    std_msgs::Header header;
    header.stamp = stamp;
    header.frame_id = "camera";
    infos_.publish(drawn_camera_info(header));
    images_.publish(encode_image(scene_.render(placed, frames_++), header));
  }

  DetectedObjectArray::ConstPtr array_of(const ros::Time& stamp) const {
    for (const auto& array : arrays_)
      if (array->header.stamp == stamp && array->status != DetectedObjectArray::STALE) return array;
    return nullptr;
  }

  /// Shows the next image and returns its detections. On a busy machine an image may be lost; then
  /// the following one is used.
  DetectedObjectArray::ConstPtr show(const std::vector<Pose2D>& poses) {
    for (int attempt = 0; attempt < 10; ++attempt) {
      set_clock(now_ + kInterval);
      publish(poses, now_);
      const auto answered = [this] {
        set_clock(now_);
        return array_of(now_) != nullptr;
      };
      if (spin_until(answered, std::chrono::seconds(5))) return array_of(now_);
    }
    ADD_FAILURE() << "no image is answered";
    return boost::make_shared<DetectedObjectArray>();
  }

  /// Shows images until the objects at all poses have frames.
  DetectedObjectArray::ConstPtr show_until_framed(const std::vector<Pose2D>& poses) {
    DetectedObjectArray::ConstPtr array;
    const auto framed = [&](const Pose2D& pose) {
      const DetectedObject* object = nearest(*array, pose);
      return object != nullptr && !object->child_frame_id.empty();
    };
    for (int i = 0; i < 30; ++i) {
      array = show(poses);
      if (std::all_of(poses.begin(), poses.end(), framed)) break;
    }
    return array;
  }

  static const DetectedObject* nearest(const DetectedObjectArray& array, const Pose2D& pose) {
    const DetectedObject* best = nullptr;
    double least = 10;
    for (const auto& object : array.objects) {
      const double distance =
          std::hypot(object.image_pose.x - pose.x, object.image_pose.y - pose.y);
      if (distance < least) best = &object;
      least = std::min(least, distance);
    }
    return best;
  }

  ros::NodeHandle node_;
  ros::Publisher clock_, images_, infos_;
  ros::Subscriber detections_;
  std::vector<DetectedObjectArray::ConstPtr> arrays_;
  const sim::Scene scene_{drawn_scene()};
  ros::Time now_;
  std::uint64_t frames_ = 10;
  static double start_;  // [s] each test has a later one
  static bool taught_;
};

double Session::start_ = 0;
bool Session::taught_ = false;

TEST_F(Session, EqualObjectsThatPassEachOtherKeepTheirIdentity) {
  const auto left = [](int i) { return Pose2D{60. + 5 * i, 110, 0.3}; };
  const auto right = [](int i) { return Pose2D{340. - 5 * i, 185, -0.8}; };
  auto array = show_until_framed({left(0), right(0)});
  ASSERT_EQ(array->objects.size(), 2u);
  const std::uint32_t ids[] = {nearest(*array, left(0))->instance_id,
                               nearest(*array, right(0))->instance_id};
  EXPECT_NE(ids[0], ids[1]);
  const std::string frames[] = {nearest(*array, left(0))->child_frame_id,
                                nearest(*array, right(0))->child_frame_id};
  EXPECT_NE(frames[0], "");
  EXPECT_NE(frames[0], frames[1]);
  for (int i = 1; i < 50; ++i) {
    array = show({left(i), right(i)});
    const DetectedObject* found[] = {nearest(*array, left(i)), nearest(*array, right(i))};
    for (int k : {0, 1}) EXPECT_TRUE(!found[k] || found[k]->instance_id == ids[k]) << i;
  }
  array = show_until_framed({left(50), right(50)});
  ASSERT_EQ(array->objects.size(), 2u);
  EXPECT_EQ(nearest(*array, left(50))->child_frame_id, frames[0]);
  EXPECT_EQ(nearest(*array, right(50))->child_frame_id, frames[1]);
}

TEST_F(Session, LateDuplicateAndFutureImagesAreNotSearched) {
  const Pose2D pose{150, 120, 0.5};
  show({pose});
  const ros::Time duplicate = now_;
  set_clock(now_ + ros::Duration(5));
  const ros::Time late = now_ - ros::Duration(2), future = now_ + ros::Duration(2);
  arrays_.clear();
  for (const auto& stamp : {duplicate, late, future}) publish({pose}, stamp);
  show({pose});
  for (const auto& stamp : {duplicate, late, future}) EXPECT_FALSE(array_of(stamp)) << stamp;
}

TEST_F(Session, FrozenClockIsDetected) {
  const Pose2D pose{150, 120, 0.5};
  for (int i = 0; i < 5; ++i) show({pose});
  EXPECT_TRUE(spin_until([this] { return arrays_.back()->status == DetectedObjectArray::STALE; }));
  EXPECT_TRUE(arrays_.back()->objects.empty());
  const auto array = show({pose});
  EXPECT_EQ(array->status, DetectedObjectArray::OK) << "it recovers alone";
  ASSERT_EQ(array->objects.size(), 1u);
  EXPECT_NE(array->objects[0].state, DetectedObject::CONFIRMED) << "sightings before the silence";
}

TEST_F(Session, ContinuesAfterTheClockJumpedBack) {
  const Pose2D pose{150, 120, 0.5};
  for (int i = 0; i < 5; ++i) show({pose});
  const ros::Time before = now_;
  set_clock(now_ - ros::Duration(100));
  ASSERT_TRUE(spin_until([&] {
    set_clock(now_);
    return ros::Time::now() < before;
  }));
  arrays_.clear();
  for (int i = 0; i < 4; ++i) show({pose});
  const auto array = show({pose});
  ASSERT_EQ(array->objects.size(), 1u);
  EXPECT_EQ(array->objects[0].state, DetectedObject::CONFIRMED);
}

TEST_F(Session, ExampleConsumerTakesOnlyConfirmedObjects) {
  const Pose2D pose{150, 120, 0.5};
  const auto consume = [&](const std::string& arguments) {
    auto ended = std::async(std::launch::async, [arguments] {
      const std::string command = "rosrun mbncc_vision grasp_client.py " + arguments + " 2>&1";
      std::string output;
      FILE* pipe = popen(command.c_str(), "r");
      std::array<char, 256> part;
      while (fgets(part.data(), part.size(), pipe)) output += part.data();
      return std::make_pair(pclose(pipe), output);
    });
    while (ended.wait_for(std::chrono::seconds(0)) != std::future_status::ready) show({pose});
    return ended.get();
  };
  const auto taken = consume("--name part --timeout 20");
  EXPECT_EQ(taken.first, 0) << taken.second;
  EXPECT_NE(taken.second.find("position"), std::string::npos) << taken.second;
  const auto refused = consume("--name nobody --timeout 2");
  EXPECT_NE(refused.first, 0);
  EXPECT_NE(refused.second.find("nothing to grasp"), std::string::npos) << refused.second;
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "session_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
