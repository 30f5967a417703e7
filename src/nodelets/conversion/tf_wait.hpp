// SPDX-License-Identifier: BSD-3-Clause
// Waits for a robot's tf, which arrives slightly later than the images of its camera.
#pragma once

#include <ros/time.h>
#include <tf2_ros/buffer.h>

#include <string>

namespace mbncc::nodelets {

/// Returns once `tf` knows the pose of `source` in `target` at `stamp`. Waits only if the two are
/// connected and the newest transform is older than the stamp by at most `patience`, and at most
/// for `patience`. Does not wait for a missing, outdated or static transform. `patience` is in
/// seconds of the steady clock; 0 or less: no waiting.
void wait_for_transform(const tf2_ros::Buffer& tf, const std::string& target,
                        const std::string& source, const ros::Time& stamp, double patience);

/// tf's error message, with a remedy if tf lags behind or does not connect the frames.
std::string tf_fault(const tf2::TransformException& error);

}  // namespace mbncc::nodelets
