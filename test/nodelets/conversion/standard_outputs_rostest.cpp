// SPDX-License-Identifier: BSD-3-Clause
// Outputs for programs that use only standard messages and frames, compared with detected_objects.
#include <geometry_msgs/PoseArray.h>
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tf2_ros/transform_listener.h>
#include <vision_msgs/Detection2DArray.h>
#include <vision_msgs/Detection3DArray.h>
#include <vision_msgs/VisionInfo.h>

#include <cmath>
#include <map>
#include <string>

#include "nodelets/call_service.hpp"
#include "nodelets/simulated_cell.hpp"

namespace mbncc::nodelets {
namespace {

/// Stores the messages of a topic by their stamps.
template <class Message>
class Heard {
 public:
  Heard(ros::NodeHandle& node, const std::string& topic)
      : subscriber_(node.subscribe<Message>(topic, 10, [this](const typename Message::ConstPtr& m) {
          messages_[m->header.stamp] = *m;
        })) {}

  bool has(const ros::Time& stamp) const { return messages_.count(stamp) > 0; }
  const Message& at(const ros::Time& stamp) const { return messages_.at(stamp); }
  bool empty() const { return messages_.empty(); }
  const Message& newest() const { return messages_.rbegin()->second; }

 private:
  std::map<ros::Time, Message> messages_;
  ros::Subscriber subscriber_;
};

class StandardOutputs : public SimulatedCell {
 protected:
  /// Teaches the object and marks the grasp, then puts the object down elsewhere.
  void teach_with_grasp(const std::string& name) {
    ASSERT_NO_FATAL_FAILURE(teach(name, [] {
      std_srvs::Trigger mark;
      ASSERT_TRUE(call_service("mark_grasp", mark));
      ASSERT_TRUE(mark.response.success) << mark.response.message;
    }));
    order("camera/put_next");
    ASSERT_TRUE(spin_until([this] { return rests(true); }));
  }

  geometry_msgs::Transform transform(const std::string& frame, const ros::Time& stamp) {
    EXPECT_TRUE(spin_until([&] { return tf_.canTransform("base_link", frame, stamp); })) << frame;
    return tf_.lookupTransform("base_link", frame, stamp).transform;
  }

  tf2_ros::Buffer tf_;
  tf2_ros::TransformListener listener_{tf_};
  Heard<geometry_msgs::PoseArray> poses_{node_, "matching/poses"};
  Heard<vision_msgs::Detection2DArray> detections_2d_{node_, "vision/detections"};
  Heard<vision_msgs::Detection3DArray> detections_3d_{node_, "vision/detections_3d"};
  Heard<vision_msgs::VisionInfo> infos_{node_, "vision/vision_info"};
};

TEST_F(StandardOutputs, AgreeWithDetectedObjects) {
  teach_with_grasp("part");
  const ros::Time since = truth_->header.stamp;
  ASSERT_TRUE(spin_until([&] { return confirmed_since(since) != nullptr; }));
  const DetectedObject object = *confirmed_since(since);
  const ros::Time stamp = found_->header.stamp;
  ASSERT_EQ(found_->header.frame_id, "base_link");
  ASSERT_TRUE(spin_until(
      [&] { return poses_.has(stamp) && detections_2d_.has(stamp) && detections_3d_.has(stamp); }));
  ASSERT_EQ(poses_.at(stamp).poses.size(), 1u);
  EXPECT_EQ(poses_.at(stamp).header.frame_id, "base_link");
  EXPECT_EQ(poses_.at(stamp).poses[0], object.pose.pose);
  ASSERT_EQ(detections_2d_.at(stamp).detections.size(), 1u);
  const auto& flat = detections_2d_.at(stamp).detections[0];
  EXPECT_EQ(flat.bbox.center.theta, object.image_pose.theta);
  EXPECT_EQ(flat.results.at(0).pose, object.pose);
  ASSERT_EQ(detections_3d_.at(stamp).detections.size(), 1u);
  const auto& solid = detections_3d_.at(stamp).detections[0];
  EXPECT_EQ(solid.results.at(0).pose, object.pose);
  EXPECT_NEAR(solid.bbox.size.x, object.size.x, 1e-3);

  ASSERT_TRUE(spin_until([&] { return !infos_.empty(); }));
  XmlRpc::XmlRpcValue ids;
  ASSERT_TRUE(ros::param::get(infos_.newest().database_location, ids));
  EXPECT_EQ(static_cast<int>(ids["part"]), flat.results.at(0).id);
  EXPECT_GT(infos_.newest().database_version, 0);

  // z points out of the platform, and the frames agree with the messages.
  const auto stable = transform("object_part", stamp), numbered = transform("object_part_0", stamp);
  EXPECT_EQ(stable, numbered);
  EXPECT_EQ(stable.translation.x, object.pose.pose.position.x);
  EXPECT_NEAR(std::hypot(stable.rotation.x, stable.rotation.y), 0, 1e-6)
      << "z is up, as the base's is";
  EXPECT_NEAR(stable.translation.z, 0, 1e-6);
  const auto grasp = transform("object_part_grasp", stamp);
  EXPECT_NEAR(grasp.translation.x, object.grasp.position.x, 1e-9);
  EXPECT_NEAR(grasp.translation.y, object.grasp.position.y, 1e-9);
  EXPECT_NEAR(grasp.translation.z, 0.1, 1e-6) << "as marked above the platform";
  EXPECT_NEAR(std::hypot(grasp.rotation.x, grasp.rotation.y), 1, 1e-6) << "and pointing down";

  // An empty message reports that the objects are gone.
  order("camera/take_away");
  ASSERT_TRUE(spin_until([this] { return rests(false); }));
  const ros::Time gone = truth_->header.stamp;
  ASSERT_TRUE(spin_until([&] {
    return !poses_.empty() && poses_.newest().header.stamp > gone &&
           poses_.newest().poses.empty() && detections_2d_.newest().header.stamp > gone &&
           detections_2d_.newest().detections.empty() &&
           detections_3d_.newest().header.stamp > gone &&
           detections_3d_.newest().detections.empty();
  }));
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "standard_outputs_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
