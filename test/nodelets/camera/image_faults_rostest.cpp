// SPDX-License-Identifier: BSD-3-Clause
// Images that change their size repeatedly, that show nothing, and whose tf frames are missing. The
// nodelets run in this process, so that sanitizers check them. MBNCC_IMAGES: number of size
// changes; a tenth of it is the number of empty images. Latencies are written to the test's report.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <tf2_msgs/TFMessage.h>
#include <tf2_ros/transform_broadcaster.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>
#include <vector>

#include "mbncc/learning/learn_object.hpp"
#include "mbncc/library/object_library.hpp"
#include "mbncc/sim/scene.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/spin_until.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObjectArray;

const cv::Size kSize{160, 120};  // of the lesson
constexpr int kBurst = 20;       // images at once
const std::string kCameraFrame = "camera", kPlatformFrame = "platform";

int images() {
  const char* text = std::getenv("MBNCC_IMAGES");
  return text == nullptr ? 1000 : std::atoi(text);
}

sim::SceneConfig scene_config() {
  sim::SceneConfig config;
  config.size = kSize;
  return config;
}

sensor_msgs::CameraInfo camera_info(const std_msgs::Header& header, const cv::Size& size) {
  sensor_msgs::CameraInfo info;
  info.header = header;
  info.width = static_cast<std::uint32_t>(size.width);
  info.height = static_cast<std::uint32_t>(size.height);
  const double f = 200, x = size.width / 2.0, y = size.height / 2.0;
  info.K = {f, 0, x, 0, f, y, 0, 0, 1};
  info.P = {f, 0, x, 0, 0, f, y, 0, 0, 0, 1, 0};
  return info;
}

double percentile(std::vector<double> values, double part) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

class ImageFaults : public testing::Test {
 protected:
  ImageFaults() {
    images_ = node_.advertise<sensor_msgs::Image>("image_raw", 1);
    infos_ = node_.advertise<sensor_msgs::CameraInfo>("camera_info", 1);
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", kBurst, [this](const DetectedObjectArray::ConstPtr& array) {
          if (array->status == DetectedObjectArray::STALE) return;
          array_ = array;
          ++answers_;
        });
    ros::param::set("/matching/library_path", folder_.path());
    ros::param::set("/matching/max_age", 10.0);  // a busy machine may search late
    Lesson lesson;
    lesson.name = "part";
    lesson.before = part_there_;
    lesson.after = scene_.render({}, 2);
    ObjectLibrary(folder_.path())
        .save(learn_object(lesson).object, ObjectLibrary::Existing::kRefuse);
  }

  ~ImageFaults() override {
    loader_.reset();
    ros::param::del("/matching");
  }

  void load(const std::string& platform_frame = "", const std::string& target_frame = "") {
    ros::param::set("/matching/platform_distance", platform_frame.empty() ? 0.5 : 0.0);
    ros::param::set("/matching/platform_frame", platform_frame);
    ros::param::set("/matching/target_frame", target_frame);
    loader_ = std::make_unique<nodelet::Loader>(false);
    ASSERT_TRUE(loader_->load("/matching", "mbncc_vision/MatchingNodelet", {}, {}));
    ASSERT_TRUE(spin_until([this] {
      return images_.getNumSubscribers() > 0 && infos_.getNumSubscribers() > 0 &&
             detections_.getNumPublishers() > 0;
    }));
  }

  /// The header of the next image.
  std_msgs::Header next_header() {
    std_msgs::Header header;
    header.stamp = std::max(ros::Time::now(), last_stamp_ + ros::Duration(0, 1));
    header.frame_id = kCameraFrame;
    last_stamp_ = header.stamp;
    return header;
  }

  /// Publishes an image and waits for its detections.
  const DetectedObjectArray& show(const cv::Mat& image, bool with_camera_info = true) {
    const std_msgs::Header header = next_header();
    if (with_camera_info) infos_.publish(camera_info(header, image.size()));
    images_.publish(encode_image(image, header));
    EXPECT_TRUE(spin_until([&] { return array_ && array_->header.stamp == header.stamp; }))
        << "no image is lost when one at a time is shown";
    if (!array_) array_ = boost::make_shared<DetectedObjectArray>();
    return *array_;
  }

  const test::TemporaryFolder folder_;
  const sim::Scene scene_{scene_config()};
  const cv::Mat part_there_ = scene_.render({{{11, 50, 1.6}, {80.3, 60.4, 0.3}}}, 1);
  ros::NodeHandle node_;
  ros::Publisher images_, infos_;
  ros::Subscriber detections_;
  DetectedObjectArray::ConstPtr array_;
  int answers_ = 0;
  std::set<std::string> frames_;  // sent by tf
  ros::Time last_stamp_;
  std::unique_ptr<nodelet::Loader> loader_;
};

TEST_F(ImageFaults, AChangingResolutionIsHandled) {
  load();
  const std::vector<cv::Size> others{{320, 240}, {80, 60}, {161, 120},
                                     {120, 160}, {2, 2},   {640, 3}};
  int found = 0;
  for (int i = 0; i < images(); ++i) {
    cv::Mat other;
    cv::resize(part_there_, other, others[static_cast<std::size_t>(i) % others.size()]);
    const DetectedObjectArray& odd = show(other);
    EXPECT_TRUE(odd.objects.empty()) << other.size();
    EXPECT_TRUE(odd.searched.empty() && odd.skipped.size() == 1) << other.size();
    const DetectedObjectArray& usual = show(part_there_);
    found += usual.objects.size() == 1 ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_EQ(found, images()) << "found in every image of the lesson's size";
}

TEST_F(ImageFaults, AQueueAnswersEveryImageOfABurst) {
  ros::param::set("/matching/queue_size", kBurst);
  load();
  show(part_there_);
  const int before = answers_;
  for (int i = 0; i < kBurst; ++i) images_.publish(encode_image(part_there_, next_header()));
  EXPECT_TRUE(spin_until([&] { return answers_ == before + kBurst; }))
      << answers_ - before << " of " << kBurst;
  EXPECT_EQ(array_->header.stamp, last_stamp_) << "in their order";
}

TEST_F(ImageFaults, EmptyImagesGiveNoDetections) {
  load();
  cv::RNG random(3);
  for (int i = 0; i < 10 * images(); ++i) {
    cv::Mat image(kSize, CV_8UC3, cv::Scalar::all(i % 3 == 0 ? 0 : 255));
    if (i % 3 == 1) image.setTo(cv::Scalar(random.uniform(0, 256), random.uniform(0, 256), 7));
    if (i % 3 == 2) random.fill(image, cv::RNG::UNIFORM, 0, 1 + i % 256);
    const DetectedObjectArray& array = show(image);
    ASSERT_TRUE(array.objects.empty()) << i;
  }
  // An image that has changed completely may be searched in several steps.
  EXPECT_TRUE(spin_until([this] { return show(part_there_).objects.size() == 1; }))
      << "and then the part is found";
}

TEST_F(ImageFaults, AnOldCameraInfoIsIgnored) {
  ros::param::set("/matching/max_info_age", 2.0);
  load();
  const auto is_posed = [this](bool with_camera_info) {
    const DetectedObjectArray& array = show(part_there_, with_camera_info);
    return !array.objects.empty() && array.objects[0].pose_valid;
  };
  ASSERT_TRUE(spin_until([&] { return is_posed(true); }));
  EXPECT_TRUE(spin_until([&] { return !is_posed(false); }));
  EXPECT_EQ(array_->status, DetectedObjectArray::UNCALIBRATED);
  EXPECT_NE(array_->message.find("max_info_age"), std::string::npos) << array_->message;
  EXPECT_TRUE(spin_until([&] { return is_posed(true); })) << "a new one counts";
}

TEST_F(ImageFaults, APlatformOfAnotherCameraGivesNoMetres) {
  tf2_ros::TransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped platform;
  platform.header.frame_id = kCameraFrame;
  platform.child_frame_id = kPlatformFrame;
  platform.transform.translation.z = 0.5;
  platform.transform.rotation.x = 1;  // its z axis points at the camera
  const auto is_posed = [&] {
    platform.header.stamp = ros::Time::now() + ros::Duration(1);
    broadcaster.sendTransform(platform);
    const DetectedObjectArray& array = show(part_there_);
    return !array.objects.empty() && array.objects[0].pose_valid;
  };
  const auto tf = node_.subscribe<tf2_msgs::TFMessage>(
      "/tf", 100, [&](const tf2_msgs::TFMessage::ConstPtr& message) {
        for (const auto& one : message->transforms) frames_.insert(one.child_frame_id);
      });
  ros::param::set("/matching/platform_intrinsics", "rectified 160 120 201 201 80 60");
  load(kPlatformFrame);
  for (int i = 0; i < 30; ++i) {
    EXPECT_FALSE(is_posed());
    EXPECT_EQ(array_->status, DetectedObjectArray::UNCALIBRATED);
  }
  EXPECT_NE(array_->message.find("another calibration"), std::string::npos) << array_->message;
  EXPECT_EQ(array_->objects.size(), 1u) << "in pixels";
  EXPECT_EQ(frames_, std::set<std::string>{kPlatformFrame});
  ros::param::set("/matching/platform_intrinsics", "rectified 160 120 200 200 80 60");
  load(kPlatformFrame);
  EXPECT_TRUE(spin_until(is_posed)) << "of the same camera";
}

/// Latencies of the images, and what their arrays contained.
struct Shown {
  std::vector<double> latencies;  // [ms]
  int posed = 0;                  // number of arrays with a pose in metres
};

TEST_F(ImageFaults, MissingTransformsDelayNothing) {
  const int count = images() / 5;
  const auto measure = [&](const std::string& what) {
    Shown shown;
    for (int i = 0; i < count; ++i) {
      const DetectedObjectArray& array = show(part_there_);
      shown.latencies.push_back(1000 * array.latency);
      shown.posed += !array.objects.empty() && array.objects[0].pose_valid ? 1 : 0;
    }
    RecordProperty(what + "_p50_ms", std::to_string(percentile(shown.latencies, 0.5)));
    RecordProperty(what + "_p99_ms", std::to_string(percentile(shown.latencies, 0.99)));
    return shown;
  };
  const auto is_posed = [this] {
    const DetectedObjectArray& array = show(part_there_);
    return !array.objects.empty() && array.objects[0].pose_valid;
  };
  load();
  ASSERT_TRUE(spin_until(is_posed)) << "the first camera_info may come after its image";
  const Shown without_tf = measure("no_tf_needed");
  EXPECT_EQ(without_tf.posed, count);
  load(kPlatformFrame, kPlatformFrame);
  const Shown missing = measure("tf_missing");
  EXPECT_EQ(missing.posed, 0);
  EXPECT_EQ(array_->status, DetectedObjectArray::UNCALIBRATED);
  tf2_ros::TransformBroadcaster broadcaster;
  geometry_msgs::TransformStamped platform;
  platform.header.stamp = ros::Time::now() - ros::Duration(1);
  platform.header.frame_id = kCameraFrame;
  platform.child_frame_id = kPlatformFrame;
  platform.transform.translation.z = 0.5;
  platform.transform.rotation.x = 1;  // its z axis points at the camera
  broadcaster.sendTransform(platform);
  const Shown outdated = measure("tf_too_old");
  EXPECT_EQ(outdated.posed, 0);
  // A lookup that waits would cost tens of milliseconds; a busy machine delays all images alike.
  const double usual = percentile(without_tf.latencies, 0.5);
  EXPECT_LT(percentile(missing.latencies, 0.5), 3 * usual + 20);
  EXPECT_LT(percentile(outdated.latencies, 0.5), 3 * usual + 20);
  EXPECT_TRUE(spin_until([&] {
    platform.header.stamp = ros::Time::now() + ros::Duration(1);
    broadcaster.sendTransform(platform);
    return is_posed();
  })) << "and then the transform counts";
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "image_faults_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
