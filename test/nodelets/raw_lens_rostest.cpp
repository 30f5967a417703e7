// Metres from the raw pictures of a distorted camera, with a cell that is started as it is.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <cmath>

#include "nodelets/simulated_cell.hpp"
#include "nodelets/teacher.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kFar = 0.28;          // [m] from the optical axis, where the lens shifts by 6.7 mm
constexpr double kMostError = 0.0025;  // [m], about a pixel
constexpr int kMostPlaces = 12;

double beside(const geometry_msgs::Pose& a, const geometry_msgs::Pose& b) {
  return std::hypot(a.position.x - b.position.x, a.position.y - b.position.y);
}

class RawLens : public SimulatedCell {
 protected:
  const geometry_msgs::Pose& true_pose() const { return truth_->objects[0].pose.pose; }

  /// Puts the object down at new places until one is far from the optical axis.
  void put_far_out() {
    for (int place = 0; place < kMostPlaces; ++place) {
      order("camera/put_next");
      ASSERT_TRUE(spin_until([this] { return rests(true); }));
      if (beside(true_pose(), geometry_msgs::Pose()) > kFar) return;
    }
    FAIL() << "no place is far enough out";
  }
};

TEST_F(RawLens, DoesNotMoveWhatIsFound) {
  Teacher teacher;
  ASSERT_TRUE(teacher.connect());
  ASSERT_TRUE(spin_until([this] { return rests(true); }));
  Teacher::Goal goal;
  goal.name = "part";
  const std::string id = teacher.send(goal);
  ASSERT_TRUE(spin_until([&] { return teacher.heard(id, Teacher::Feedback::WAIT_REMOVAL); }));
  order("camera/take_away");
  const auto lesson = teacher.await(id).result;
  ASSERT_EQ(lesson.error_code, Teacher::Result::SUCCESS) << lesson.message;
  put_far_out();
  const ros::Time since = truth_->header.stamp;
  const auto seen = [&]() -> const DetectedObject* {
    if (!found_ || found_->header.stamp <= since || found_->objects.empty()) return nullptr;
    return &found_->objects.front();
  };
  ASSERT_TRUE(spin_until([&] { return seen() != nullptr; }));
  ASSERT_TRUE(seen()->pose_valid) << found_->message;
  EXPECT_LT(beside(seen()->pose.pose, true_pose()), kMostError);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "raw_lens_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
