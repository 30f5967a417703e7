// SPDX-License-Identifier: BSD-3-Clause
// Images with 16 bits, of a part of the sensor, with binned pixels and from a fisheye lens: the
// pose is correct, or the refusal names the remedy. The matching nodelet runs in this process.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/ExplainPlace.h>
#include <nodelet/loader.h>
#include <ros/ros.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <set>
#include <string>

#include "mbncc/learning/learn_object.hpp"
#include "mbncc/library/object_library.hpp"
#include "mbncc/sim/scene.hpp"
#include "nodelets/call_service.hpp"
#include "nodelets/conversion/images.hpp"
#include "nodelets/spin_until.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

const cv::Size kSize{160, 120};        // [px] of every image
constexpr int kWhite = 4095;           // of a camera with 12 bits
constexpr double kFocalLength = 200;   // [px]
constexpr double kDistance = 0.5;      // [m] of the platform
constexpr double kMostPixels = 0.3;    // [px] error of a position in the image
constexpr double kMostAngle = 0.02;    // [rad]
constexpr double kMostColour = 20;     // [grey levels] 8 to 12 by a mosaic and the drawing
constexpr double kMostMisfit = 0.001;  // [px] from the pose in metres to that in the image

sim::SceneConfig scene_config() {
  sim::SceneConfig config;
  config.size = kSize;
  return config;
}

sensor_msgs::Image message_of(const cv::Mat& image, const std::string& encoding) {
  sensor_msgs::Image message;
  message.encoding = encoding;
  message.width = static_cast<std::uint32_t>(image.cols);
  message.height = static_cast<std::uint32_t>(image.rows);
  message.step = static_cast<std::uint32_t>(image.cols * image.elemSize());
  message.data.assign(image.datastart, image.dataend);
  return message;
}

cv::Mat grey(const cv::Mat& image) {
  cv::Mat result;
  cv::cvtColor(image, result, cv::COLOR_BGR2GRAY);
  return result;
}

cv::Mat with_12_bits(const cv::Mat& image) {
  cv::Mat result;
  image.convertTo(result, CV_16U, kWhite / 255.0);
  return result;
}

/// Bayer mosaic with red, green, red ... in the first row and green, blue ... in the second one.
cv::Mat rggb_mosaic(const cv::Mat& image) {
  constexpr int kChannels[2][2] = {{2, 1}, {1, 0}};  // of bgr
  cv::Mat mosaic(image.size(), CV_8UC1);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      mosaic.at<std::uint8_t>(y, x) = image.at<cv::Vec3b>(y, x)[kChannels[y % 2][x % 2]];
  return mosaic;
}

/// Calibration of a sensor whose centre is the optical axis and whose pixels all contribute to the
/// image.
sensor_msgs::CameraInfo info_of(cv::Size sensor) {
  sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(sensor.width);
  info.height = static_cast<std::uint32_t>(sensor.height);
  const double f = kFocalLength, x = sensor.width / 2.0, y = sensor.height / 2.0;
  info.K = {f, 0, x, 0, f, y, 0, 0, 1};
  info.P = {f, 0, x, 0, 0, f, y, 0, 0, 0, 1, 0};
  return info;
}

class ImageFormats : public testing::Test {
 protected:
  ImageFormats() {
    images_ = node_.advertise<sensor_msgs::Image>("image_raw", 1);
    infos_ = node_.advertise<sensor_msgs::CameraInfo>("camera_info", 1);
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 100, [this](const DetectedObjectArray::ConstPtr& array) {
          array_ = array;
          statuses_.insert(array->status);
          if (array->status != DetectedObjectArray::STALE) answered_.insert(array->header.stamp);
        });
    ros::param::set("/matching/library_path", folder_.path());
    ros::param::set("/matching/platform_distance", kDistance);
    ros::param::set("/matching/max_age", 100.0);  // a busy machine may search late
  }

  ~ImageFormats() override {
    loader_.reset();
    ros::param::del("/matching");
  }

  void teach(bool in_grey) {
    const auto prepared = [&](const cv::Mat& image) {
      cv::Mat result = image;
      if (in_grey) cv::cvtColor(grey(image), result, cv::COLOR_GRAY2BGR);
      return result;
    };
    Lesson lesson;
    lesson.name = "part";
    lesson.before = prepared(scene_.render({{kPart, kTaughtAt}}, 1));
    lesson.after = prepared(scene_.render({}, 2));
    const LearnResult learned = learn_object(lesson);
    ASSERT_TRUE(learned.has_model) << learned.message;
    ObjectLibrary(folder_.path()).save(learned.object, ObjectLibrary::Existing::kRefuse);
    expected_ =
        compose(compose(kShownAt, inverse(kTaughtAt)), learned.object.views.front().reference);
  }

  void load() {
    loader_ = std::make_unique<nodelet::Loader>(false);
    ASSERT_TRUE(loader_->load("/matching", "mbncc_vision/MatchingNodelet", {}, {}));
    ASSERT_TRUE(spin_until([this] {
      return images_.getNumSubscribers() > 0 && infos_.getNumSubscribers() > 0 &&
             detections_.getNumPublishers() > 0;
    }));
  }

  /// Publishes an image with its camera_info; returns its stamp.
  ros::Time publish(sensor_msgs::Image sent, sensor_msgs::CameraInfo info = info_of(kSize)) {
    sent.header.stamp = std::max(ros::Time::now(), last_stamp_ + ros::Duration(0, 1));
    return publish_at(sent.header.stamp, sent, info);
  }

  ros::Time publish_at(const ros::Time& stamp, sensor_msgs::Image sent,
                       sensor_msgs::CameraInfo info = info_of(kSize)) {
    sent.header.frame_id = "camera";
    sent.header.stamp = last_stamp_ = stamp;
    info.header = sent.header;
    infos_.publish(info);
    images_.publish(sent);
    return stamp;
  }

  bool is_answered(const ros::Time& stamp) {
    return spin_until([&] { return answered_.count(stamp) > 0; });
  }

  /// The part's detection with a pose in metres; repeats, because the first camera_info may arrive
  /// after its image.
  DetectedObject find(const sensor_msgs::Image& sent, const sensor_msgs::CameraInfo& info) {
    const bool found = spin_until([&] {
      return is_answered(publish(sent, info)) && array_->objects.size() == 1 &&
             array_->objects[0].pose_valid;
    });
    EXPECT_TRUE(found) << (array_ ? array_->message : "no message");
    return found ? array_->objects[0] : DetectedObject();
  }

  void expect_place(const DetectedObject& found) const {
    EXPECT_NEAR(found.image_pose.x, expected_.x, kMostPixels);
    EXPECT_NEAR(found.image_pose.y, expected_.y, kMostPixels);
    EXPECT_NEAR(wrap_angle(found.image_pose.theta - expected_.theta), 0, kMostAngle);
  }

  /// Explains the part's place in the next live image.
  mbncc_vision::ExplainPlace::Response explain(const sensor_msgs::Image& sent) {
    mbncc_vision::ExplainPlace call;
    call.request.place.x = expected_.x;
    call.request.place.y = expected_.y;
    const auto answer =
        std::async(std::launch::async, [&] { return call_service("matching/explain", call); });
    EXPECT_TRUE(spin_until([&] {
      publish(sent);
      return answer.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    }));
    return call.response;
  }

  /// Publishes images until a STALE message says why no image is usable.
  std::string refusal_of(const sensor_msgs::Image& sent) {
    EXPECT_TRUE(spin_until([&] {
      publish(sent);
      return array_ && array_->status == DetectedObjectArray::STALE;
    }));
    return array_ ? array_->message : "";
  }

  const sim::SceneObject kPart{11, 50, 1.6};
  const Pose2D kTaughtAt{80.3, 60.4, 0.3}, kShownAt{74.8, 63.1, 0.9};
  const test::TemporaryFolder folder_;
  const sim::Scene scene_{scene_config()};
  const cv::Mat shown_ = scene_.render({{kPart, kShownAt}}, 3);
  Pose2D expected_;
  ros::NodeHandle node_;
  ros::Publisher images_, infos_;
  ros::Subscriber detections_;
  std::unique_ptr<nodelet::Loader> loader_;
  DetectedObjectArray::ConstPtr array_;
  std::set<ros::Time> answered_;  // stamps
  std::set<int> statuses_;
  ros::Time last_stamp_;
};

class GreyImages : public ImageFormats, public testing::WithParamInterface<const char*> {};

TEST_P(GreyImages, TwelveBitImagesAreSearchedAndExplained) {
  ros::param::set("/matching/white_level", kWhite);
  teach(true);
  load();
  const auto sent = message_of(with_12_bits(grey(shown_)), GetParam());
  expect_place(find(sent, info_of(kSize)));
  const auto explained = explain(sent);
  EXPECT_TRUE(explained.success) << explained.message;
  EXPECT_NE(explained.message.find("found, and may be grasped"), std::string::npos)
      << explained.message;
}

INSTANTIATE_TEST_SUITE_P(Encodings, GreyImages, testing::Values("mono16", "16UC1"));

TEST_F(ImageFormats, SixteenBitsWithoutAWhiteLevelAreRefused) {
  teach(true);
  load();
  EXPECT_NE(refusal_of(message_of(with_12_bits(grey(shown_)), "16UC1")).find("set white_level"),
            std::string::npos)
      << array_->message;
  EXPECT_TRUE(array_->objects.empty());
}

TEST_F(ImageFormats, ATwelveBitBayerMosaicHasItsColours) {
  ros::param::set("/matching/white_level", kWhite);
  teach(false);
  load();
  const auto sent = message_of(with_12_bits(rggb_mosaic(shown_)), "bayer_rggb16");
  expect_place(find(sent, info_of(kSize)));
  const Decoded drawn = decode_image(explain(sent).picture);
  ASSERT_EQ(drawn.image.size(), kSize) << drawn.fault;
  cv::Mat difference;
  cv::absdiff(drawn.image, shown_, difference);
  const cv::Scalar mean = cv::mean(difference);
  EXPECT_LT(std::max(mean[0], mean[2]), kMostColour) << "blue and red in their places";
}

TEST_F(ImageFormats, ASensorRegionKeepsItsPosition) {
  teach(false);
  load();
  auto info = info_of({400, 300});
  info.roi.x_offset = 50;
  info.roi.y_offset = 130;
  info.roi.width = static_cast<std::uint32_t>(kSize.width);
  info.roi.height = static_cast<std::uint32_t>(kSize.height);
  const DetectedObject found = find(message_of(shown_, "bgr8"), info);
  expect_place(found);
  const auto& place = found.pose.pose.position;
  EXPECT_NEAR(kFocalLength * place.x / kDistance + 200 - 50, found.image_pose.x, kMostMisfit);
  EXPECT_NEAR(kFocalLength * place.y / kDistance + 150 - 130, found.image_pose.y, kMostMisfit);
}

TEST_F(ImageFormats, BinnedPixelsCoverSeveralSensorPixels) {
  teach(false);
  load();
  auto info = info_of({320, 240});
  info.binning_x = info.binning_y = 2;
  const DetectedObject found = find(message_of(shown_, "bgr8"), info);
  expect_place(found);
  const auto& place = found.pose.pose.position;
  const auto binned = [](double sensor) { return (sensor - 0.5) / 2; };
  EXPECT_NEAR(binned(kFocalLength * place.x / kDistance + 160), found.image_pose.x, kMostMisfit);
  EXPECT_NEAR(binned(kFocalLength * place.y / kDistance + 120), found.image_pose.y, kMostMisfit);
}

TEST_F(ImageFormats, AFisheyeMapsByTheAngle) {
  ros::param::set("/matching/rectified", false);
  teach(false);
  load();
  auto info = info_of(kSize);
  info.distortion_model = "equidistant";
  info.D = {0.1, 0, 0, 0};
  // The principal point is moved away, so that the lens has an effect.
  info.K[2] = 10;
  const DetectedObject found = find(message_of(shown_, "bgr8"), info);
  expect_place(found);
  const auto& place = found.pose.pose.position;
  const double radius = std::hypot(place.x, place.y), angle = std::atan(radius / kDistance);
  const double seen = kFocalLength * angle * (1 + 0.1 * angle * angle);
  EXPECT_NEAR(10 + seen * place.x / radius, found.image_pose.x, kMostMisfit);
  EXPECT_NEAR(60 + seen * place.y / radius, found.image_pose.y, kMostMisfit);
  EXPECT_GT(std::abs(10 + kFocalLength * place.x / kDistance - found.image_pose.x), 1)
      << "a pinhole camera would not show it there";

  info.D.push_back(0);
  EXPECT_TRUE(spin_until([&] {
    return is_answered(publish(message_of(shown_, "bgr8"), info)) &&
           array_->status == DetectedObjectArray::UNCALIBRATED &&
           array_->message.find("equidistant has 4") != std::string::npos;
  })) << array_->message;
}

TEST_F(ImageFormats, ARegionOutsideTheImageIsRefused) {
  ros::param::set("/matching/search_roi", "1000,1000,20,20");
  teach(false);
  load();
  const std::string message = refusal_of(message_of(shown_, "bgr8"));
  EXPECT_NE(message.find("'search_roi' lies outside the image of 160 x 120"), std::string::npos)
      << message;
  EXPECT_EQ(statuses_, std::set<int>{DetectedObjectArray::STALE});
}

TEST_F(ImageFormats, AnotherSizeIsReportedWithTheRemedy) {
  teach(false);
  load();
  cv::Mat larger;
  cv::resize(shown_, larger, {}, 2, 2);
  const auto sent = message_of(larger, "bgr8");
  ASSERT_TRUE(is_answered(publish(sent, info_of(larger.size()))));
  ASSERT_EQ(array_->skipped.size(), 1u);
  EXPECT_NE(array_->skipped[0].find("teach it again at this size"), std::string::npos)
      << array_->skipped[0];
  const std::string message = explain(sent).message;
  EXPECT_NE(message.find("teach it again at this size"), std::string::npos) << message;
}

// Stamps that double precision represents exactly: of 32 images per second, 24 are three out of
// four.
TEST_F(ImageFormats, TheRateIsMeasuredByTheStamps) {
  ros::param::set("/matching/max_rate", 24.0);
  teach(false);
  load();
  const ros::Time first(ros::Time::now().sec - 3, 0);
  const auto sent = message_of(shown_, "bgr8");
  std::size_t passed = 0;
  for (int i = 0; i <= 64; ++i) {
    const ros::Time stamp = publish_at(first + ros::Duration(0, 31250000 * i), sent);
    // There is no message to wait for the other images; an image that was overtaken would get none.
    if (i % 4 == 1) continue;
    ASSERT_TRUE(is_answered(stamp)) << i;
    ++passed;
  }
  EXPECT_EQ(passed, 49u) << "the first one, then 24 in each of two seconds";
  EXPECT_EQ(answered_.size(), passed);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "image_formats_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
