// SPDX-License-Identifier: BSD-3-Clause
// Messages about an image, and the conditions for moving an arm.
#include "nodelets/matching/detection_pipeline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
#include <vector>

#include "mbncc/library/object_library.hpp"
#include "nodelets/conversion/pose_algebra.hpp"
#include "nodelets/matching/frame_permission.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

const cv::Size kSize(320, 240);

class DetectionPipelineTest : public testing::Test {
 protected:
  /// A textured angle on a plain platform, learned at its place.
  DetectionPipelineTest() : image_(kSize, CV_8UC3, cv::Scalar(110, 110, 110)) {
    cv::Mat map = cv::Mat::zeros(kSize, CV_8UC1), texture(kSize, CV_8UC3);
    map(cv::Rect(130, 80, 24, 70)) = 255;
    map(cv::Rect(130, 126, 60, 24)) = 255;
    cv::RNG(3).fill(texture, cv::RNG::UNIFORM, 0, 256);
    cv::GaussianBlur(texture, texture, {}, 2);
    cv::normalize(texture, texture, 20, 235, cv::NORM_MINMAX);
    texture.copyTo(image_, map);
    ObjectModel model;
    model.name = model.label = "angle";
    model.object_height = 0.02;
    model.metres_per_pixel = 0.48 / 300;
    model.grasp = Grasp{{{0.01, 0.02, -0.1}}, {{0, 0, 0, 1}}};
    model.views.push_back(crop_view(image_, map, {150, 120, 0.3}));
    ObjectLibrary(folder_.path()).save(model, ObjectLibrary::Existing::kRefuse);
    config_.platform.platform_distance = 0.5;
  }

  ReceivedImage received(int number) const {
    ReceivedImage received;
    received.image = image_;
    received.header.frame_id = "camera";
    received.header.stamp = ros::Time(100 + 0.1 * number);
    const auto info = boost::make_shared<sensor_msgs::CameraInfo>();
    info->header = received.header;
    info->width = kSize.width;
    info->height = kSize.height;
    info->distortion_model = "plumb_bob";
    info->D.assign(5, 0);
    info->K = {300, 0, 159.5, 0, 300, 119.5, 0, 0, 1};
    info->R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    info->P = {300, 0, 159.5, 0, 0, 300, 119.5, 0, 0, 0, 1, 0};
    received.camera_info = info;
    return received;
  }

  /// The message about the last of several equal images, with the frames that may be sent.
  DetectedObjectArray after(int images) {
    const LiveMatcher matcher({}, folder_.path());
    DetectionPipeline pipeline(config_, matcher, tf_);
    DetectedObjectArray last;
    for (int i = 0; i < images; ++i) {
      ReceivedImage next = received(i);
      if (!calibrated_) next.camera_info.reset();
      last = pipeline.process(next, {}).array;
    }
    permit_frames(last, ros::Time(), true);
    return last;
  }

  test::TemporaryFolder folder_;
  cv::Mat image_;
  MatchingNodeConfig config_;
  tf2_ros::Buffer tf_;
  bool calibrated_ = true;
};

TEST_F(DetectionPipelineTest, AConfirmedObjectGetsAFrame) {
  for (const int images : {1, 2, 3}) {
    const DetectedObjectArray array = after(images);
    ASSERT_EQ(array.objects.size(), 1u);
    const DetectedObject& object = array.objects[0];
    EXPECT_EQ(array.status, DetectedObjectArray::OK) << array.message;
    EXPECT_EQ(object.state, images < 3 ? DetectedObject::NEW : DetectedObject::CONFIRMED);
    EXPECT_EQ(object.child_frame_id, images < 3 ? "" : "object_angle_0");
    EXPECT_TRUE(object.pose_valid);
    // The object's top face is 20 mm nearer than the platform.
    EXPECT_NEAR(object.pose.pose.position.z, 0.48, 1e-6);
    EXPECT_NEAR(object.pose.pose.position.x, (150 - 159.5) / 300 * 0.48, 1e-4);
    const double observed = 0.1 * (images - 1);
    const double valid = images == 1 ? config_.max_age : std::min(config_.max_age, 2 * observed);
    EXPECT_NEAR(object.valid_until.toSec(), 100 + observed + valid, 1e-6);
  }
}

TEST_F(DetectionPipelineTest, WithoutCalibrationThereAreNoMetresAndNoFrames) {
  calibrated_ = false;
  const DetectedObjectArray array = after(3);
  ASSERT_EQ(array.objects.size(), 1u);
  EXPECT_EQ(array.status, DetectedObjectArray::UNCALIBRATED);
  EXPECT_FALSE(array.message.empty());
  EXPECT_EQ(array.objects[0].state, DetectedObject::CONFIRMED);
  EXPECT_FALSE(array.objects[0].pose_valid);
  EXPECT_TRUE(std::isnan(array.objects[0].pose.pose.position.x));
  EXPECT_EQ(array.objects[0].child_frame_id, "");
}

TEST_F(DetectionPipelineTest, ATiltedCameraIsReportedAndRaisesTheCovariance) {
  const DetectedObjectArray upright = after(1);
  ASSERT_EQ(upright.objects.size(), 1u);
  EXPECT_EQ(upright.message, "");
  config_.platform.platform_frame = "platform";
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "camera";
  transform.child_frame_id = "platform";
  transform.transform.translation.z = 0.5;
  transform.transform.rotation.x = std::sin(0.05);
  transform.transform.rotation.w = std::cos(0.05);
  tf_.setTransform(transform, "test", true);
  const DetectedObjectArray tilted = after(1);
  ASSERT_EQ(tilted.objects.size(), 1u);
  EXPECT_EQ(tilted.status, DetectedObjectArray::OK);
  EXPECT_NE(tilted.message.find("tilted (by 5.7 degrees)"), std::string::npos) << tilted.message;
  EXPECT_NE(tilted.message.find("top_view:=true"), std::string::npos) << tilted.message;
  const auto yaw_variance = [](const DetectedObjectArray& array) {
    return array.objects[0].pose.covariance[35];
  };
  EXPECT_GT(yaw_variance(tilted), yaw_variance(upright) + 0.015 * 0.015);
}

TEST_F(DetectionPipelineTest, WithoutTheTargetFrameThereAreNoFrames) {
  config_.target_frame = "base";
  const DetectedObjectArray array = after(3);
  ASSERT_EQ(array.objects.size(), 1u);
  EXPECT_EQ(array.status, DetectedObjectArray::TF_UNAVAILABLE);
  EXPECT_EQ(array.header.frame_id, "camera") << "what the poses are in";
  EXPECT_EQ(array.objects[0].child_frame_id, "");
}

TEST_F(DetectionPipelineTest, PosesAreInTheTargetFrameAsItWasAtTheImagesStamp) {
  config_.target_frame = "base";
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "base";
  transform.child_frame_id = "camera";
  transform.transform.rotation.x = 1;  // looks straight down
  for (const double stamp : {100., 101.}) {
    transform.header.stamp = ros::Time(stamp);
    transform.transform.translation.x = stamp - 99.2;  // the camera moves
    tf_.setTransform(transform, "test");
  }
  const DetectedObjectArray array = after(3);
  ASSERT_EQ(array.objects.size(), 1u);
  EXPECT_EQ(array.status, DetectedObjectArray::OK) << array.message;
  EXPECT_EQ(array.header.frame_id, "base");
  EXPECT_NEAR(array.objects[0].pose.pose.position.z, -0.48, 1e-6);
  EXPECT_NEAR(array.objects[0].pose.pose.position.x, 1 + (150 - 159.5) / 300 * 0.48, 1e-4);
  EXPECT_EQ(array.objects[0].child_frame_id, "object_angle_0");
}

TEST_F(DetectionPipelineTest, NoFrameHasTheNameOfAnotherObjectsFrame) {
  const auto add = [&](const std::string& name) {
    ObjectModel copy = *ObjectLibrary(folder_.path()).load()->find("angle");
    copy.name = copy.label = name;
    copy.enabled = false;
    ObjectLibrary(folder_.path()).save(copy, ObjectLibrary::Existing::kRefuse);
  };
  add("angle_0");
  DetectedObjectArray array = after(3);
  ASSERT_EQ(array.objects.size(), 1u);
  EXPECT_EQ(array.objects[0].state, DetectedObject::CONFIRMED);
  EXPECT_EQ(array.objects[0].child_frame_id, "");
  EXPECT_EQ(array.objects[0].stable_frame_id, "object_angle");
  EXPECT_NE(array.message.find("'angle_0'"), std::string::npos) << array.message;
  add("angle_grasp");
  array = after(3);
  EXPECT_EQ(array.objects[0].stable_frame_id, "") << "its grasp frame is object_angle_grasp";
}

TEST_F(DetectionPipelineTest, AHeldPoseStaysWhereItWasWhenTheCameraMoves) {
  config_.platform.platform_frame = "platform";
  config_.target_frame = "platform";
  config_.hold_time = 30;
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "camera";
  transform.child_frame_id = "platform";
  transform.transform.translation.z = 0.5;
  transform.transform.rotation.w = 1;
  const auto move_to = [&](double x, int number) {
    transform.transform.translation.x = x;
    transform.header.stamp = received(number).header.stamp;
    tf_.setTransform(transform, "test");
  };
  move_to(0, 0);
  move_to(0.1, 2);
  const LiveMatcher matcher({}, folder_.path());
  DetectionPipeline pipeline(config_, matcher, tf_);
  const DetectedObject seen = pipeline.process(received(0), {}).array.objects.at(0);
  image_.setTo(cv::Scalar(110, 110, 110));
  const DetectedObject held = pipeline.process(received(2), {}).array.objects.at(0);
  EXPECT_EQ(held.state, DetectedObject::HELD);
  ASSERT_TRUE(held.pose_valid);
  EXPECT_NEAR(held.pose.pose.position.x, seen.pose.pose.position.x, 1e-9);
  EXPECT_NEAR(held.grasp.position.x, seen.grasp.position.x, 1e-9);
  move_to(0.2, 200);
  const DetectedObject later = pipeline.process(received(200), {}).array.objects.at(0);
  EXPECT_EQ(later.state, DetectedObject::HELD);
  EXPECT_FALSE(later.pose_valid) << "tf has forgotten where the platform was";
}

TEST_F(DetectionPipelineTest, TheGraspIsInTheFrameOfThePoses) {
  config_.target_frame = "base";
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "base";
  transform.child_frame_id = "camera";
  transform.transform.rotation.x = 1;  // looks straight down
  tf_.setTransform(transform, "test", true);
  const DetectedObject object = after(3).objects.at(0);
  ASSERT_TRUE(object.has_grasp);
  const auto& pose = object.pose.pose.position;
  const auto& grasp = object.grasp.position;
  const double c = std::cos(0.3), s = std::sin(0.3);
  EXPECT_NEAR(grasp.x - pose.x, c * 0.01 - s * 0.02, 1e-4);
  EXPECT_NEAR(grasp.y - pose.y, -(s * 0.01 + c * 0.02), 1e-4) << "y points the other way";
  EXPECT_NEAR(grasp.z - pose.z, 0.1, 1e-9) << "above the object";
}

/// Transforms the point `p` from the object's frame to that of the array.
template <class Point>
cv::Vec3d placed(const DetectedObject& object, const Point& p) {
  geometry_msgs::Pose point;
  point.position.x = p.x;
  point.position.y = p.y;
  point.position.z = p.z;
  point.orientation.w = 1;
  const auto at = compose(object.pose.pose, point).position;
  return {at.x, at.y, at.z};
}

TEST_F(DetectionPipelineTest, ZPointsIntoThePlatformOrOutOfIt) {
  const DetectedObject into = after(3).objects.at(0);
  config_.object_frame_z = "out";
  const DetectedObject out = after(3).objects.at(0);
  const cv::Vec3d z = placed(into, cv::Point3d(0, 0, 1)) - placed(into, cv::Point3d());
  EXPECT_NEAR(z[2], 1, 1e-9) << "the camera looks along its z";
  for (const auto& [one, other] : {std::pair(cv::Point3d(1, 0, 0), cv::Point3d(1, 0, 0)),
                                   {cv::Point3d(0, 1, 0), cv::Point3d(0, -1, 0)},
                                   {cv::Point3d(0, 0, 1), cv::Point3d(0, 0, -1)}})
    EXPECT_LE(cv::norm(placed(into, one) - placed(out, other)), 1e-9);
  EXPECT_EQ(into.grasp, out.grasp) << "the gripper does not turn with it";
  EXPECT_EQ(into.pose.covariance, out.pose.covariance) << "about the axes of the array's frame";
}

TEST_F(DetectionPipelineTest, TheFootprintLiesOnThePlatform) {
  for (const std::string z : {"into", "out"}) {
    config_.object_frame_z = z;
    const DetectedObject object = after(3).objects.at(0);
    ASSERT_FALSE(object.footprint.points.empty());
    std::vector<cv::Point2f> pixels;
    for (const auto& corner : object.footprint.points) {
      const cv::Vec3d at = placed(object, corner);
      EXPECT_NEAR(at[2], 0.5, 1e-6) << z;
      pixels.emplace_back(static_cast<float>(at[0] / 0.48 * 300 + 159.5),
                          static_cast<float>(at[1] / 0.48 * 300 + 119.5));
    }
    const cv::Rect2f box = cv::boundingRect(pixels);
    EXPECT_NEAR(box.x, 130, 1.5) << z;
    EXPECT_NEAR(box.y, 80, 1.5) << z;
    EXPECT_NEAR(box.width, 60, 2.5) << z;
  }
}

TEST_F(DetectionPipelineTest, AHeldInstanceOfAnEarlierLessonHasNoMetres) {
  config_.hold_time = 10;
  LiveMatcher matcher({}, folder_.path());
  DetectionPipeline pipeline(config_, matcher, tf_);
  for (int i = 0; i < 3; ++i) ASSERT_EQ(pipeline.process(received(i), {}).array.objects.size(), 1u);
  ObjectLibrary(folder_.path()).edit("angle", [](ObjectModel& model) {
    model.object_height = 0.1;
  });
  matcher.refresh(false);
  image_.setTo(cv::Scalar::all(110));
  const DetectedObjectArray array = pipeline.process(received(3), {}).array;
  ASSERT_EQ(array.objects.size(), 1u);
  EXPECT_EQ(array.objects[0].state, DetectedObject::HELD);
  EXPECT_FALSE(array.objects[0].pose_valid) << "its height was another one";
}

TEST_F(DetectionPipelineTest, AnEmptyLibraryIsReported) {
  ObjectLibrary(folder_.path()).remove("angle");
  EXPECT_EQ(after(1).status, DetectedObjectArray::LIBRARY_EMPTY);
}

}  // namespace
}  // namespace mbncc::nodelets
