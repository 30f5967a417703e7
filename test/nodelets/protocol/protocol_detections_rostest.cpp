// SPDX-License-Identifier: BSD-3-Clause
// Detections without images, without calibration, with malformed images, on request and while
// disabled; settings at run time.
#include <dynamic_reconfigure/Reconfigure.h>
#include <mbncc_vision/FindObjects.h>
#include <sensor_msgs/CompressedImage.h>
#include <std_srvs/SetBool.h>
#include <visualization_msgs/MarkerArray.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <map>
#include <thread>

#include "nodelets/call_service.hpp"
#include "nodelets/protocol/protocol.hpp"

namespace mbncc::nodelets {
namespace {

TEST_F(Protocol, ReportsStaleWithoutImagesAndLibraryEmptyWithThem) {
  ASSERT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::STALE); }));
  EXPECT_TRUE(array_->objects.empty());
  std::size_t marks = 0;
  const auto markers = node_.subscribe<visualization_msgs::MarkerArray>(
      "matching/markers", 5, [&](const visualization_msgs::MarkerArray::ConstPtr& array) {
        if (status_is(DetectedObjectArray::STALE)) marks = array->markers.size();
      });
  EXPECT_TRUE(spin_until([&] { return marks == 1; }));  // the earlier markers are deleted
  {
    const ros::WallTimer playing = play();
    ASSERT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::LIBRARY_EMPTY); }));
    EXPECT_EQ(array_->image_width, 320u);
  }
  EXPECT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::STALE); }));
}

TEST_F(Protocol, DiagnosticsReportThatImagesStopped) {
  const std::string stopped = "no images arrive; check the camera and its cable";
  const auto is_error = [&](const std::string& nodelet) {
    return health_is(nodelet, diagnostic_msgs::DiagnosticStatus::ERROR, stopped);
  };
  {
    const ros::WallTimer playing = play();
    ASSERT_TRUE(spin_until([&] {
      return health_is("matching", diagnostic_msgs::DiagnosticStatus::WARN) &&
             health_is("learning", diagnostic_msgs::DiagnosticStatus::OK);
    }));
  }
  EXPECT_TRUE(spin_until([&] { return is_error("matching") && is_error("learning"); }));
}

TEST_F(Protocol, DiagnosticsReportThatNoImageIsUsable) {
  const ros::WallTimer playing = node_.createWallTimer(ros::WallDuration(0.1), [this](const auto&) {
    sensor_msgs::Image image = before_;
    image.header.stamp = ros::Time::now();
    image.encoding = "nonsense";
    images_.publish(image);
  });
  EXPECT_TRUE(spin_until([this] {
    const auto level = diagnostic_msgs::DiagnosticStatus::ERROR;
    return health_is("matching", level, "no usable image: ") &&
           health_is("learning", level, "no usable image: ");
  }));
}

TEST_F(Protocol, DiagnosticsReportTheAgeOfALateImage) {
  const ros::WallTimer playing = node_.createWallTimer(ros::WallDuration(0.1), [this](const auto&) {
    sensor_msgs::Image image = before_;
    image.header.stamp = ros::Time::now() - ros::Duration(10000);
    images_.publish(image);
  });
  EXPECT_TRUE(spin_until([this] {
    return health_is("matching", diagnostic_msgs::DiagnosticStatus::ERROR,
                     "no usable image: an image's stamp is late, by 1e+04 s; ");
  }));
}

TEST_F(Protocol, DiagnosticsNameTheTopicWithoutPublisher) {
  images_.shutdown();
  EXPECT_TRUE(spin_until([this] {
    return health_is("matching", diagnostic_msgs::DiagnosticStatus::ERROR,
                     "no publisher of images on /image_raw; ");
  }));
}

TEST_F(Protocol, AMissingLibraryFolderIsAnErrorAndRefusesGoals) {
  std::string folder;
  ASSERT_TRUE(ros::param::get("learning/library_path", folder));
  const ros::WallTimer playing = play();
  std::filesystem::rename(folder, folder + "_away");
  EXPECT_TRUE(spin_until([this] {
    const auto level = diagnostic_msgs::DiagnosticStatus::ERROR;
    return health_is("matching", level, "the library cannot be read: ") &&
           health_is("learning", level, "the library cannot be read: ");
  }));
  const auto end = teacher_.await(teacher_.send(given("homeless")));
  EXPECT_TRUE(edit("homeless", EditObject::Request::DISABLE).retry) << "the folder may come back";
  std::filesystem::rename(folder + "_away", folder);
  EXPECT_EQ(end.status.status, actionlib_msgs::GoalStatus::REJECTED);
  EXPECT_EQ(end.result.error_code, Result::STORAGE) << end.result.message;
  EXPECT_FALSE(edit("homeless", EditObject::Request::DISABLE).retry) << "there is no such object";
  EXPECT_TRUE(spin_until([this] {
    return health_is("matching", diagnostic_msgs::DiagnosticStatus::WARN) &&
           health_is("learning", diagnostic_msgs::DiagnosticStatus::OK);
  })) << "and goes on when the folder is back";
}

TEST_F(Protocol, FindsWithoutCalibrationInPixelsOnlyAndSendsNoTf) {
  const Result lesson = teacher_.teach(given("part"));
  ASSERT_EQ(lesson.error_code, Result::SUCCESS) << lesson.message;
  const ros::WallTimer playing = play();
  ASSERT_TRUE(spin_until([this] {
    return status_is(DetectedObjectArray::UNCALIBRATED) && array_->objects.size() == 1 &&
           array_->objects[0].state == DetectedObject::CONFIRMED;
  }));
  const DetectedObject& object = array_->objects[0];
  EXPECT_FALSE(array_->message.empty());
  EXPECT_NEAR(object.image_pose.x, lesson.object.reference.x, 1);
  EXPECT_NEAR(object.image_pose.y, lesson.object.reference.y, 1);
  EXPECT_FALSE(object.pose_valid);
  EXPECT_TRUE(std::isnan(object.pose.pose.position.x));
  EXPECT_EQ(object.child_frame_id + object.stable_frame_id, "");
  EXPECT_EQ(transforms_heard_, 0);

  EXPECT_TRUE(edit("part", EditObject::Request::DISABLE).success);
  EXPECT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::LIBRARY_EMPTY); }));
  EXPECT_TRUE(edit("part", EditObject::Request::ENABLE).success);
  EXPECT_TRUE(edit("part", EditObject::Request::RENAME, "piece").success);
  EXPECT_TRUE(spin_until(
      [this] { return array_->objects.size() == 1 && array_->objects[0].name == "piece"; }));
  EXPECT_TRUE(edit("piece", EditObject::Request::DELETE).success);
  EXPECT_TRUE(edit("piece", EditObject::Request::RESTORE).success);
  EXPECT_FALSE(edit("nothing", EditObject::Request::DELETE).success);
  EXPECT_TRUE(edit("piece", EditObject::Request::DELETE).success);
}

TEST_F(Protocol, FindsOnceOnRequest) {
  ASSERT_EQ(teacher_.teach(given("part")).error_code, Result::SUCCESS);
  mbncc_vision::FindObjects::Request request;
  request.image = before_;
  const auto find = [&] { return call<mbncc_vision::FindObjects>("find_objects", request); };
  ASSERT_TRUE(spin_until([&] { return find().detections.objects.size() == 1; }));
  const auto found = find();
  EXPECT_TRUE(found.success);
  ASSERT_EQ(found.detections.objects.size(), 1u);
  EXPECT_EQ(found.detections.objects[0].instance_id, 0u) << "of no stream";
  request.names = {"nobody"};
  const auto other = find();
  EXPECT_TRUE(other.success);
  EXPECT_TRUE(other.detections.objects.empty());
  EXPECT_TRUE(other.detections.searched.empty());
  EXPECT_EQ(other.detections.skipped, std::vector<std::string>{"nobody: unknown"});
  request.names = {"part"};
  EXPECT_EQ(find().detections.objects.size(), 1u);
  request.names.clear();
  request.image.header.stamp = ros::Time::now() + ros::Duration(3600);
  EXPECT_FALSE(find().success) << "stamped in the future";
  request.image = after_;
  EXPECT_TRUE(find().success);
  EXPECT_TRUE(find().detections.objects.empty());
  request.image.data.pop_back();
  EXPECT_FALSE(find().success);
  request.image = before_;
  request.roi.width = 1000;
  EXPECT_FALSE(find().success);
  request.roi.width = 0;
  request.names.assign(1001, "part");
  EXPECT_FALSE(find().success) << "more names than objects can have";
  request.names = {"../part"};
  EXPECT_FALSE(find().success);
  request = {};
  request.timeout = ros::Duration(0.2);
  EXPECT_FALSE(find().success) << "no live images";
  EXPECT_TRUE(edit("part", EditObject::Request::DELETE).success);
}

// Without images, each call waits until its timeout; a call in excess of the limit must not.
TEST_F(Protocol, CallsInExcessOfTheLimitAreAnsweredBusy) {
  constexpr int kCalls = 30;
  std::atomic<int> busy{0}, out_of_time{0}, ended{0};
  std::vector<std::thread> callers;
  for (int i = 0; i < kCalls; ++i)
    callers.emplace_back([&] {
      mbncc_vision::FindObjects service;
      service.request.timeout = ros::Duration(3);
      const bool answered = call_service("find_objects", service);
      if (answered && !service.response.success) {
        const bool refused = service.response.message.rfind("BUSY", 0) == 0;
        ++(refused ? busy : out_of_time);
      }
      ++ended;
    });
  EXPECT_TRUE(spin_until([&] { return ended == kCalls; }));
  for (auto& caller : callers) caller.join();
  EXPECT_EQ(busy + out_of_time, kCalls) << "every call is answered";
  EXPECT_GT(busy, 0);
  EXPECT_GE(out_of_time, 4) << "so many are heard";
  mbncc_vision::FindObjects::Request request;
  request.image = before_;
  EXPECT_TRUE(call<mbncc_vision::FindObjects>("find_objects", request).success) << "and then again";
}

TEST_F(Protocol, IsIdleWhileDisabled) {
  const ros::WallTimer playing = play();
  ASSERT_TRUE(spin_until([this] { return arrays_ > 0 && !status_is(DetectedObjectArray::STALE); }));
  std_srvs::SetBool::Request request;
  request.data = false;
  EXPECT_TRUE(call<std_srvs::SetBool>("matching/enable", request).success);
  EXPECT_TRUE(spin_until([this] { return images_.getNumSubscribers() == 1; }))
      << "the matching nodelet still listens, besides the learning nodelet";
  EXPECT_EQ(call<std_srvs::SetBool>("matching/enable", request).message, "idle: disabled");
  request.data = true;
  EXPECT_TRUE(call<std_srvs::SetBool>("matching/enable", request).success);
  const int before = arrays_;
  EXPECT_TRUE(spin_until([&] { return arrays_ > before; }));
}

TEST_F(Protocol, AcceptsSettingsAtRunTimeAndRefusesInvalidOnes) {
  dynamic_reconfigure::Reconfigure::Request request;
  request.config.doubles.resize(2);
  request.config.doubles[0].name = "min_score";
  request.config.doubles[0].value = 0.45;
  request.config.doubles[1].name = "max_rate";
  request.config.doubles[1].value = -3;
  const auto response = call<dynamic_reconfigure::Reconfigure>("matching/set_parameters", request);
  std::map<std::string, double> effective;
  for (const auto& number : response.config.doubles) effective[number.name] = number.value;
  EXPECT_EQ(effective["min_score"], 0.45);
  EXPECT_EQ(effective["max_rate"], 0) << "refused; the old value is kept";
  double stored = 0;
  EXPECT_TRUE(ros::param::get("matching/min_score", stored));
  EXPECT_EQ(stored, 0.45);
  request.config.doubles[0].value = 0.3;
  request.config.doubles.pop_back();
  call<dynamic_reconfigure::Reconfigure>("matching/set_parameters", request);
}

TEST_F(Protocol, DrawsImagesForSubscribers) {
  ASSERT_EQ(teacher_.teach(given("part")).error_code, Result::SUCCESS);
  const ros::WallTimer playing = play();
  sensor_msgs::Image::ConstPtr scores;
  sensor_msgs::CompressedImage::ConstPtr jpeg;
  const auto score_subscriber = node_.subscribe<sensor_msgs::Image>(
      "matching/score_map", 1, [&](const auto& heard) { scores = heard; });
  const auto jpeg_subscriber = node_.subscribe<sensor_msgs::CompressedImage>(
      "matching/overlay_jpeg", 1, [&](const auto& heard) { jpeg = heard; });
  ASSERT_TRUE(spin_until([&] { return scores && jpeg; }));
  EXPECT_EQ(scores->encoding, "bgr8");
  EXPECT_EQ(scores->width, 320u);
  EXPECT_GT(jpeg->data.size(), 1000u);
  EXPECT_TRUE(edit("part", EditObject::Request::DELETE).success);
}

TEST_F(Protocol, SurvivesMalformedImages) {
  const ros::WallTimer playing = play();
  ASSERT_TRUE(spin_until([this] { return images_.getNumSubscribers() > 0; }));
  for (const auto& spoil : std::vector<void (*)(sensor_msgs::Image&)>{
           [](auto& m) { m.width = m.height = 0xffffffffu; }, [](auto& m) { m.step = 0; },
           [](auto& m) { m.data.clear(); }, [](auto& m) { m.encoding = "nonsense"; },
           [](auto& m) { m.width = 0; }}) {
    sensor_msgs::Image image = before_;
    image.header.stamp = ros::Time::now();
    spoil(image);
    images_.publish(image);
  }
  const int before = arrays_;
  EXPECT_TRUE(spin_until(
      [&] { return arrays_ > before + 2 && status_is(DetectedObjectArray::LIBRARY_EMPTY); }));
}

}  // namespace
}  // namespace mbncc::nodelets
