// SPDX-License-Identifier: BSD-3-Clause
// The application that widgets need, and a ROS node without a master.
#include <gtest/gtest.h>
#include <ros/ros.h>

#include <QApplication>
#include <memory>

namespace {

class Application : public testing::Environment {
 public:
  void SetUp() override {
    application_ = std::make_unique<QApplication>(count_, arguments_);
    ros::init(ros::M_string{{"__master", "http://localhost:1"}}, name_,
              ros::init_options::NoSigintHandler | ros::init_options::NoRosout);
    ros::master::setRetryTimeout(ros::WallDuration(0.01));
  }
  void TearDown() override { application_.reset(); }

 private:
  int count_ = 1;
  char name_[5] = "test";
  char* arguments_[2] = {name_, nullptr};
  std::unique_ptr<QApplication> application_;
};

const auto* const kApplication = testing::AddGlobalTestEnvironment(new Application);

}  // namespace
