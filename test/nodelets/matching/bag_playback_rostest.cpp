// SPDX-License-Identifier: BSD-3-Clause
// A bag of the simulated cell is recorded, played with --clock and compared with the truth.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/FindObjects.h>
#include <ros/ros.h>
#include <rosbag/bag.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstdlib>
#include <future>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "nodelets/call_service.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/conversion/object_frames.hpp"
#include "nodelets/drawn_images.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

constexpr int kPlaces = 12, kImagesPerPlace = 8;
constexpr double kInterval = 0.2;  // [s] between images
constexpr double kDistance = 0.5;  // [m]
const ros::Time kStart(1000);

sim::Placed placed_at(const Pose2D& pose) {
  return drawn_part(80, pose);
}

class BagPlayback : public testing::Test {
 protected:
  BagPlayback() {
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 1000, [this](const DetectedObjectArray::ConstPtr& array) {
          if (array->status != DetectedObjectArray::STALE) arrays_.push_back(array);
        });
    transforms_ = node_.subscribe<tf2_msgs::TFMessage>(
        "/tf", 1000, [this](const tf2_msgs::TFMessage::ConstPtr& message) {
          for (const auto& transform : message->transforms) sent_.push_back(transform);
        });
  }

  // Random sub-pixel positions and angles, well inside the image.
  static std::vector<Pose2D> places() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> x(70, 330), y(70, 230), theta(-kPi, kPi);
    std::vector<Pose2D> poses;
    for (int i = 0; i < kPlaces; ++i) poses.push_back({x(random), y(random), theta(random)});
    return poses;
  }

  void record(const std::string& path) {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    bag.setCompression(rosbag::compression::LZ4);
    std::uint64_t frame = 100;
    for (const auto& place : places()) {
      for (int i = 0; i < kImagesPerPlace; ++i, ++frame) {
        std_msgs::Header header;
        header.stamp = kStart + ros::Duration(kInterval * static_cast<double>(frame - 100));
        header.frame_id = "camera";
        truth_[header.stamp] = place;
        bag.write("camera_info", header.stamp, drawn_camera_info(header));
        bag.write("image_raw", header.stamp,
                  encode_image(scene_.render({placed_at(place)}, frame), header));
      }
    }
  }

  void teach() {
    Teacher teacher;
    EXPECT_TRUE(teacher.connect());
    Teacher::Goal goal;
    goal.name = "part";
    goal.before = encode_image(scene_.render({placed_at(learned_at_)}, 1));
    goal.after = encode_image(scene_.render({}, 2));
    const auto lesson = teacher.teach(goal);
    ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
    const auto& reference = lesson.object.reference;
    reference_ = {reference.x, reference.y, reference.theta};
  }

  bool matching_knows_the_part() {
    mbncc_vision::FindObjects find;
    find.request.image = encode_image(scene_.render({placed_at(learned_at_)}, 3));
    return call_service("find_objects", find) && find.response.success &&
           find.response.detections.searched == std::vector<std::string>{"part"};
  }

  // Plays the whole bag and waits until its last image has been searched.
  void play(const std::string& path) {
    const std::string command = "rosbag play --clock --quiet --delay 1 " + path + " > /dev/null";
    auto playing = std::async(std::launch::async, [&] { return std::system(command.c_str()); });
    const ros::Time last = truth_.rbegin()->first;
    EXPECT_TRUE(spin_until([&] { return !arrays_.empty() && arrays_.back()->header.stamp == last; },
                           std::chrono::seconds(120)));
    EXPECT_EQ(playing.get(), 0);
    // The first images may arrive before the first calibration.
    while (!arrays_.empty() && arrays_.front()->status == DetectedObjectArray::UNCALIBRATED)
      arrays_.erase(arrays_.begin());
  }

  // Position of the taught reference point in the image with this stamp.
  Pose2D expected(const ros::Time& stamp) const {
    return compose(compose(truth_.at(stamp), inverse(learned_at_)), reference_);
  }

  void expect_true(const DetectedObjectArray& array) {
    EXPECT_EQ(array.status, DetectedObjectArray::OK) << array.message;
    EXPECT_EQ(array.header.frame_id, "camera");
    const Pose2D pose = expected(array.header.stamp);
    for (const auto& object : array.objects) {
      EXPECT_LE(std::hypot(object.image_pose.x - pose.x, object.image_pose.y - pose.y), 1.0);
      EXPECT_LE(to_degrees(angle_distance(object.image_pose.theta, pose.theta)), 1.0);
      EXPECT_TRUE(object.pose_valid);
      if (object.state == DetectedObject::CONFIRMED) confirmed_[array.header.stamp] = &object;
      EXPECT_EQ(object.child_frame_id.empty(), object.state != DetectedObject::CONFIRMED);
    }
  }

  void expect_true(const geometry_msgs::TransformStamped& transform) {
    const std::string& frame = transform.child_frame_id;
    EXPECT_EQ(transform.header.frame_id, "camera");
    const DetectedObject& object = *confirmed_[transform.header.stamp];
    EXPECT_TRUE(frame == object.child_frame_id || frame == object.stable_frame_id) << frame;
    EXPECT_EQ(object.child_frame_id.rfind("object_part_", 0), 0u);
    EXPECT_EQ(object.stable_frame_id, "object_part");
    const Pose2D pose = expected(transform.header.stamp);
    const auto& t = transform.transform.translation;
    EXPECT_NEAR(t.z, kDistance, 1e-6);
    EXPECT_NEAR(t.x * kFocalLength / t.z + kCentreX, pose.x, 1.0);
    EXPECT_NEAR(t.y * kFocalLength / t.z + kCentreY, pose.y, 1.0);
    const auto& q = transform.transform.rotation;
    EXPECT_LE(to_degrees(angle_distance(2 * std::atan2(q.z, q.w), pose.theta)), 1.0);
  }

  ros::NodeHandle node_;
  ros::Subscriber detections_, transforms_;
  std::vector<DetectedObjectArray::ConstPtr> arrays_;
  std::vector<geometry_msgs::TransformStamped> sent_;
  const sim::Scene scene_{drawn_scene()};
  const Pose2D learned_at_{200.3, 150.6, 0.4};
  Pose2D reference_;
  std::map<ros::Time, Pose2D> truth_;
  std::map<ros::Time, const DetectedObject*> confirmed_;
};

TEST_F(BagPlayback, FindsEveryPoseAndSendsTfOnceAtTheImagesStamp) {
  const test::TemporaryFolder folder;
  record(folder / "cell.bag");
  teach();
  ASSERT_TRUE(ros::service::waitForService("find_objects", 30000));
  ASSERT_TRUE(spin_until([this] { return matching_knows_the_part(); }));
  play(folder / "cell.bag");

  std::set<ros::Time> stamps;
  std::set<double> places_found;
  for (const auto& array : arrays_) {
    ASSERT_EQ(truth_.count(array->header.stamp), 1u) << "a stamp that no image has";
    EXPECT_TRUE(stamps.insert(array->header.stamp).second) << "two arrays for an image";
    expect_true(*array);
    if (!array->objects.empty()) places_found.insert(truth_[array->header.stamp].x);
  }
  EXPECT_EQ(places_found.size(), static_cast<std::size_t>(kPlaces));

  // The last transforms may still be on their way.
  EXPECT_TRUE(spin_until([&] { return sent_.size() >= 2 * confirmed_.size(); }));
  std::set<std::pair<std::string, ros::Time>> sent;
  for (const auto& transform : sent_) {
    EXPECT_TRUE(sent.emplace(transform.child_frame_id, transform.header.stamp).second)
        << "tf twice for a stamp";
    // The first transform of the stable frame for another instance; see ObjectFrames.
    const ros::Duration step(0, ObjectFrames::kStep);
    if (confirmed_.count(transform.header.stamp - step) == 1) continue;
    ASSERT_EQ(confirmed_.count(transform.header.stamp), 1u) << "tf without a confirmed detection";
    expect_true(transform);
  }
  EXPECT_GE(sent.size(), 2 * confirmed_.size());
  EXPECT_GE(confirmed_.size(), static_cast<std::size_t>(kPlaces));
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "bag_playback_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
