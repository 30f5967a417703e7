// SPDX-License-Identifier: BSD-3-Clause
// Guarantees for clients under faults (protocol_*_rostest.cpp).
#include <gtest/gtest.h>
#include <ros/ros.h>

#include "nodelets/teacher.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "protocol_rostest");
  const int failed = RUN_ALL_TESTS();
  mbncc::nodelets::remove_library();
  return failed;
}
