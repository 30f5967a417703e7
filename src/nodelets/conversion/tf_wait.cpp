// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/tf_wait.hpp"

#include <chrono>
#include <thread>

namespace mbncc::nodelets {
namespace {

constexpr std::chrono::milliseconds kPollInterval{1};  // between two checks of tf

/// Whether the frames are connected, but their newest transform is older than `stamp`, by at most
/// `patience` [s].
bool lags_behind(const tf2_ros::Buffer& tf, const std::string& target, const std::string& source,
                 const ros::Time& stamp, double patience) {
  try {
    const ros::Time newest = tf.lookupTransform(target, source, ros::Time(0)).header.stamp;
    // A static transform has no stamp.
    return !newest.isZero() && newest < stamp && (stamp - newest).toSec() <= patience;
  } catch (const tf2::TransformException&) {
    return false;
  }
}

}  // namespace

void wait_for_transform(const tf2_ros::Buffer& tf, const std::string& target,
                        const std::string& source, const ros::Time& stamp, double patience) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(patience);
  while (Clock::now() < end && lags_behind(tf, target, source, stamp, patience))
    std::this_thread::sleep_for(kPollInterval);
}

std::string tf_fault(const tf2::TransformException& error) {
  std::string words = error.what();
  words.erase(words.find_last_not_of(" .") + 1);  // without tf's own full stop
  if (words.find("into the future") != std::string::npos)
    return words + "; if the robot's tf lags behind, set tf_wait";
  const bool unconnected = dynamic_cast<const tf2::LookupException*>(&error) != nullptr ||
                           dynamic_cast<const tf2::ConnectivityException*>(&error) != nullptr;
  return words + (unconnected
                      ? "; publish the transforms between camera and robot (a fixed camera: "
                        "static_transform_publisher), or correct the frame's name"
                      : "");
}

}  // namespace mbncc::nodelets
