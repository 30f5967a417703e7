// SPDX-License-Identifier: BSD-3-Clause
// Ctrl-C during a lesson: the client gets a result, and the process shuts down in order.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "nodelets/spin_until.hpp"
#include "nodelets/teacher.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

pid_t start_learning(const std::string& library) {
  const std::string parameter = "_library_path:=" + library;
  const pid_t pid = fork();
  if (pid != 0) return pid;
  execlp("rosrun", "rosrun", "nodelet", "nodelet", "standalone", "mbncc_vision/LearningNodelet",
         "__ns:=/mortal", "__name:=learning", parameter.c_str(), nullptr);
  _exit(127);
}

TEST(Interrupted, InformsTheClientAndEndsTheProcessInOrder) {
  const test::TemporaryFolder folder;
  const pid_t pid = start_learning(folder.path());
  ASSERT_GT(pid, 0);
  Teacher teacher("mortal");
  ASSERT_TRUE(teacher.connect());
  Teacher::Goal goal;
  goal.name = "unfinished";
  const std::string id = teacher.send(goal);
  ASSERT_TRUE(spin_until([&] { return teacher.heard(id, Teacher::Feedback::WAIT_IMAGE); }));
  const auto start = std::chrono::steady_clock::now();
  ASSERT_EQ(kill(pid, SIGINT), 0);
  const auto end = teacher.await(id);
  EXPECT_EQ(end.status.status, actionlib_msgs::GoalStatus::ABORTED);
  EXPECT_EQ(end.result.error_code, Teacher::Result::CANCELLED);
  int status = -1;
  EXPECT_EQ(waitpid(pid, &status, 0), pid);
  const std::chrono::duration<double, std::milli> ended = std::chrono::steady_clock::now() - start;
  RecordProperty("ended_ms", static_cast<int>(ended.count()));
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "interrupted_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
