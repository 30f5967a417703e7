// SPDX-License-Identifier: BSD-3-Clause
// Poses in metres from the raw images of a distorted camera, with a cell that is started in the
// usual way.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <tf2/LinearMath/Quaternion.h>
#include <tf2/LinearMath/Vector3.h>

#include <cmath>
#include <functional>

#include "nodelets/simulated_cell.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kNear = 0.22;         // [m] from the optical axis, where the lens shifts by 3.3 mm
constexpr double kFar = 0.28;          // [m] where it shifts by 6.7 mm
constexpr double kMostError = 0.0005;  // [m], a quarter of a pixel
constexpr int kMostPlaces = 30;

/// Position [m] of the learned frame relative to the true one, in the object's frame; the lesson
/// chose it.
tf2::Vector3 in_object(const geometry_msgs::Pose& seen, const geometry_msgs::Pose& truth) {
  const auto& q = truth.orientation;
  const tf2::Vector3 apart(seen.position.x - truth.position.x, seen.position.y - truth.position.y,
                           seen.position.z - truth.position.z);
  return tf2::quatRotate(tf2::Quaternion(q.x, q.y, q.z, q.w).inverse(), apart);
}

class RawLens : public SimulatedCell {
 protected:
  const geometry_msgs::Pose& true_pose() const { return truth_->objects[0].pose.pose; }

  double from_axis() const { return std::hypot(true_pose().position.x, true_pose().position.y); }

  /// Puts the object down at new places until one is `wanted`, and waits for its pose there.
  void find_where(const std::function<bool(double)>& wanted, geometry_msgs::Pose& seen) {
    for (int place = 0; place == 0 || !wanted(from_axis()); ++place) {
      ASSERT_LT(place, kMostPlaces) << "no place is as wanted";
      order("camera/put_next");
      ASSERT_TRUE(spin_until([this] { return rests(true); }));
    }
    const ros::Time since = truth_->header.stamp;
    ASSERT_TRUE(spin_until(
        [&] { return found_ && found_->header.stamp > since && !found_->objects.empty(); }));
    ASSERT_TRUE(found_->objects[0].pose_valid) << found_->message;
    seen = found_->objects[0].pose.pose;
  }
};

TEST_F(RawLens, DoesNotChangeThePoses) {
  ASSERT_NO_FATAL_FAILURE(teach("part"));
  geometry_msgs::Pose seen;
  ASSERT_NO_FATAL_FAILURE(find_where([](double apart) { return apart < kNear; }, seen));
  const tf2::Vector3 near_axis = in_object(seen, true_pose());
  ASSERT_NO_FATAL_FAILURE(find_where([](double apart) { return apart > kFar; }, seen));
  EXPECT_LT((in_object(seen, true_pose()) - near_axis).length(), kMostError);
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
