// What clients may rely on when something is not as it should be: names, a busy server, cancelling,
// timeouts, no calibration, no pictures, malformed pictures, an empty library.
#include <dynamic_reconfigure/Reconfigure.h>
#include <gtest/gtest.h>
#include <mbncc_vision/ConfirmLearning.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <mbncc_vision/EditObject.h>
#include <mbncc_vision/FindObjects.h>
#include <mbncc_vision/ListObjects.h>
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "mbncc/sim/scene.hpp"
#include "nodelets/images.hpp"
#include "nodelets/messages.hpp"
#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

using actionlib_msgs::GoalStatus;
using mbncc_vision::ConfirmLearning;
using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;
using mbncc_vision::EditObject;
using Goal = Teacher::Goal;
using Result = Teacher::Result;

sim::SceneConfig scene_config() {
  sim::SceneConfig config;
  config.size = {320, 240};
  return config;
}

class Protocol : public testing::Test {
 protected:
  Protocol() {
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 100, [this](const DetectedObjectArray::ConstPtr& array) {
          array_ = array;
          ++arrays_;
        });
    transforms_ = node_.subscribe<tf2_msgs::TFMessage>(
        "/tf", 100, [this](const tf2_msgs::TFMessage::ConstPtr&) { ++transforms_heard_; });
    images_ = node_.advertise<sensor_msgs::Image>("image_raw", 1);
    before_ = encode_picture(scene_.render({part_}, 1));
    after_ = encode_picture(scene_.render({}, 2));
  }

  void SetUp() override {
    ASSERT_TRUE(teacher_.connect());
    ASSERT_TRUE(ros::service::waitForService("find_objects", 30000));
  }

  Goal given(const std::string& name) const {
    Goal goal;
    goal.name = name;
    goal.before = before_;
    goal.after = after_;
    return goal;
  }

  // Pictures of the part, without calibration, until the object goes.
  ros::WallTimer play() {
    return node_.createWallTimer(ros::WallDuration(0.1), [this](const auto&) {
      std_msgs::Header header;
      header.stamp = ros::Time::now();
      header.frame_id = "camera";
      images_.publish(encode_picture(scene_.render({part_}, ++frame_), header));
    });
  }

  void expect_refused(const Goal& goal, int code) {
    const auto end = teacher_.await(teacher_.send(goal));
    EXPECT_EQ(end.status.status, GoalStatus::REJECTED) << end.result.message;
    EXPECT_EQ(end.result.error_code, code) << end.result.message;
    EXPECT_FALSE(end.result.message.empty());
    EXPECT_FALSE(end.result.hint.empty());
  }

  bool status_is(std::uint8_t status) const { return array_ && array_->status == status; }

  template <class Service>
  typename Service::Response call(const std::string& name,
                                  const typename Service::Request& request) {
    typename Service::Response response;
    typename Service::Request copy = request;
    EXPECT_TRUE(ros::service::call(name, copy, response)) << name;
    return response;
  }

  std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const auto& object : call<mbncc_vision::ListObjects>("list_objects", {}).objects)
      names.push_back(object.name);
    return names;
  }

  EditObject::Response edit(const std::string& name, std::uint8_t command,
                            const std::string& new_name = "") {
    EditObject::Request request;
    request.name = name;
    request.command = command;
    request.new_name = new_name;
    return call<EditObject>("edit_object", request);
  }

  ConfirmLearning::Response confirm(std::uint8_t command) {
    ConfirmLearning::Request request;
    request.command = command;
    return call<ConfirmLearning>("confirm_learning", request);
  }

  const sim::Scene scene_{scene_config()};
  const sim::Placed part_{{11, 70, 1.6}, {160.2, 120.4, 0.3}};
  sensor_msgs::Image before_, after_;
  std::uint64_t frame_ = 10;
  ros::NodeHandle node_;
  Teacher teacher_;
  ros::Subscriber detections_, transforms_;
  ros::Publisher images_;
  DetectedObjectArray::ConstPtr array_;
  int arrays_ = 0, transforms_heard_ = 0;
};

TEST_F(Protocol, SaysStaleWithoutPicturesAndLibraryEmptyWithThem) {
  ASSERT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::STALE); }));
  EXPECT_TRUE(array_->objects.empty());
  {
    const ros::WallTimer playing = play();
    ASSERT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::LIBRARY_EMPTY); }));
    EXPECT_EQ(array_->image_width, 320u);
  }
  EXPECT_TRUE(spin_until([this] { return status_is(DetectedObjectArray::STALE); }));
}

TEST_F(Protocol, RejectsBadGoalsBeforeAnythingMoves) {
  for (const std::string name : {"../../x", "1part", "a b", "\xc3\xa9"})
    expect_refused(given(name), Result::NAME_INVALID);
  expect_refused(given(std::string(10000, 'x')), Result::NAME_INVALID);
  Goal goal = given("unknown");
  goal.add_view = true;
  expect_refused(goal, Result::NAME_UNKNOWN);
  goal = given("clicked");
  goal.mode = Goal::CLICK;
  goal.point.x = std::nan("");
  expect_refused(goal, Result::REGION_INVALID);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, NamesAnObjectByItselfAndRefusesATakenName) {
  const Result first = teacher_.teach(given(""));
  ASSERT_EQ(first.error_code, Result::SUCCESS) << first.message;
  EXPECT_EQ(first.object.name, "object_1");
  EXPECT_EQ(first.object.revision, 1u);
  expect_refused(given("object_1"), Result::NAME_TAKEN);
  Goal goal = given("object_1");
  goal.overwrite = true;
  EXPECT_EQ(teacher_.teach(goal).object.revision, 2u);
  EXPECT_TRUE(edit("object_1", EditObject::Request::DELETE).success);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, TeachesByRegionOutlineAndMask) {
  Goal goal = given("by_region");
  goal.mode = Goal::ROI;
  goal.roi = to_msg(cv::Rect(100, 60, 120, 120));
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  goal = given("by_mask");
  goal.mode = Goal::MASK;
  goal.mask = encode_picture(scene_.true_map(part_));
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  goal = given("by_outline");
  goal.mode = Goal::OUTLINE;
  goal.outline = to_msg(std::vector<cv::Point2f>{{130, 100}, {190, 105}, {185, 145}, {135, 140}});
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  goal = given("by_click");
  goal.mode = Goal::CLICK;
  goal.point.x = part_.pose.x;
  goal.point.y = part_.pose.y;
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::SUCCESS);
  EXPECT_EQ(names(), (std::vector<std::string>{"by_click", "by_mask", "by_outline", "by_region"}));
  for (const auto& name : names()) EXPECT_TRUE(edit(name, EditObject::Request::DELETE).success);
}

TEST_F(Protocol, RefusesPicturesThatLieOrDoNotFit) {
  Goal goal = given("part");
  goal.before.step += 1;
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::ENCODING);
  goal = given("part");
  goal.after.encoding = "32FC1";
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::ENCODING);
  goal = given("part");
  goal.after = encode_picture(cv::Mat(100, 100, CV_8UC3, cv::Scalar::all(9)));
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::IMAGE_MISMATCH);
  goal = given("part");
  goal.after = goal.before;
  EXPECT_EQ(teacher_.teach(goal).error_code, Result::NO_CHANGE);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, KeepsTheRunningLessonWhenASecondGoalComes) {
  const ros::WallTimer playing = play();
  Goal live;
  live.name = "live";
  const std::string first = teacher_.send(live);
  ASSERT_TRUE(spin_until([&] { return teacher_.heard(first, Teacher::Feedback::WAIT_REMOVAL); }));
  for (int i = 0; i < 3; ++i) expect_refused(given("second"), Result::BUSY);
  EXPECT_FALSE(call<std_srvs::Trigger>("mark_grasp", {}).success) << "no gripper_frame is set";
  EXPECT_FALSE(teacher_.ended(first));
  teacher_.cancel(first);
  const auto end = teacher_.await(first);
  EXPECT_EQ(end.status.status, GoalStatus::PREEMPTED);
  EXPECT_EQ(end.result.error_code, Result::CANCELLED);
  EXPECT_TRUE(names().empty());
}

TEST_F(Protocol, EndsALessonAtItsTimeLimit) {
  Goal goal;
  goal.name = "late";
  goal.timeout = ros::Duration(0.5);
  goal.already_moved = false;
  {
    const ros::WallTimer playing = play();
    const auto end = teacher_.await(teacher_.send(goal));
    EXPECT_EQ(end.status.status, GoalStatus::ABORTED);
    EXPECT_TRUE(end.result.error_code == Result::TIMEOUT ||
                end.result.error_code == Result::NOT_STILL ||
                end.result.error_code == Result::NO_IMAGE)
        << end.result.message;
  }
  const Result next = teacher_.teach(given("next"));
  EXPECT_EQ(next.error_code, Result::SUCCESS) << next.message;
  EXPECT_TRUE(edit("next", EditObject::Request::DELETE).success);
}

TEST_F(Protocol, AsksTheOperatorBeforeStoring) {
  EXPECT_FALSE(confirm(ConfirmLearning::Request::ACCEPT).success) << "no lesson waits";
  Goal goal = given("checked");
  goal.confirm = true;
  std::string id = teacher_.send(goal);
  const auto waits = [&] { return teacher_.heard(id, Teacher::Feedback::WAIT_CONFIRM); };
  ASSERT_TRUE(spin_until(waits));
  EXPECT_TRUE(names().empty());
  EXPECT_FALSE(confirm(ConfirmLearning::Request::UNDO).success) << "no edit yet";
  EXPECT_FALSE(confirm(ConfirmLearning::Request::EDIT).success) << "nothing to edit";
  ConfirmLearning::Request edit_reference;
  edit_reference.command = ConfirmLearning::Request::EDIT;
  edit_reference.set_reference = true;
  edit_reference.reference.x = 150;
  edit_reference.reference.y = 110;
  EXPECT_TRUE(call<ConfirmLearning>("confirm_learning", edit_reference).success);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::UNDO).success);
  ConfirmLearning::Request stroke;
  stroke.command = ConfirmLearning::Request::EDIT;
  stroke.stroke_width = 9;
  stroke.exclude.push_back(to_msg(std::vector<cv::Point2f>{{160, 80}, {160, 160}}));
  const auto area = [&] { return confirm(ConfirmLearning::Request::UNDO).quality.area; };
  const double whole = area();
  const auto cut = call<ConfirmLearning>("confirm_learning", stroke);
  EXPECT_TRUE(cut.success) << cut.message;
  EXPECT_LT(cut.quality.area, whole - 100);
  EXPECT_EQ(area(), whole) << "taken back";
  stroke.exclude[0].points[0].x = std::nanf("");
  EXPECT_FALSE(call<ConfirmLearning>("confirm_learning", stroke).success);
  EXPECT_TRUE(call<ConfirmLearning>("confirm_learning", edit_reference).success);
  EXPECT_TRUE(confirm(ConfirmLearning::Request::ACCEPT).success);
  const Result accepted = teacher_.await(id).result;
  EXPECT_EQ(accepted.error_code, Result::SUCCESS);
  EXPECT_DOUBLE_EQ(accepted.object.reference.x, 150);

  goal.name = "rejected";
  id = teacher_.send(goal);
  ASSERT_TRUE(spin_until(waits));
  EXPECT_TRUE(confirm(ConfirmLearning::Request::REJECT).success);
  EXPECT_EQ(teacher_.await(id).result.error_code, Result::REJECTED_BY_OPERATOR);
  EXPECT_EQ(names(), std::vector<std::string>{"checked"});
  EXPECT_TRUE(edit("checked", EditObject::Request::DELETE).success);
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
  EXPECT_EQ(object.child_frame_id, "");
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
  EXPECT_TRUE(find().success);
  request.image = after_;
  EXPECT_TRUE(find().success);
  EXPECT_TRUE(find().detections.objects.empty());
  request.image.data.pop_back();
  EXPECT_FALSE(find().success);
  request.image = before_;
  request.roi.width = 1000;
  EXPECT_FALSE(find().success);
  request = {};
  request.timeout = ros::Duration(0.2);
  EXPECT_FALSE(find().success) << "no live pictures";
  EXPECT_TRUE(edit("part", EditObject::Request::DELETE).success);
}

TEST_F(Protocol, IsIdleWhileDisabled) {
  const ros::WallTimer playing = play();
  ASSERT_TRUE(spin_until([this] { return arrays_ > 0 && !status_is(DetectedObjectArray::STALE); }));
  std_srvs::SetBool::Request request;
  request.data = false;
  EXPECT_TRUE(call<std_srvs::SetBool>("matching/enable", request).success);
  EXPECT_TRUE(spin_until([this] { return images_.getNumSubscribers() == 1; }))
      << "the matching nodelet still listens, besides the learning nodelet";
  request.data = true;
  EXPECT_TRUE(call<std_srvs::SetBool>("matching/enable", request).success);
  const int before = arrays_;
  EXPECT_TRUE(spin_until([&] { return arrays_ > before; }));
}

TEST_F(Protocol, TakesSettingsAtRunTimeAndRefusesNonsense) {
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

TEST_F(Protocol, DrawsPicturesForWhoLooks) {
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

TEST_F(Protocol, BearsMalformedPictures) {
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

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "protocol_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
