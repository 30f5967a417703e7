// SPDX-License-Identifier: BSD-3-Clause
// A robot's tf comes a little later than the pictures of the camera that it carries.
#pragma once

#include <ros/time.h>
#include <tf2_ros/buffer.h>

#include <string>

namespace mbncc::nodelets {

/// Returns when `tf` can tell how `source` lies in `target` at `stamp`. Waits for it only where the
/// two are connected and the newest transform is older than the stamp, though not by more than
/// `patience`, and no longer than that: a missing, outdated or fixed transform is not waited for.
/// `patience` is in seconds of the steady clock; 0 or less: not at all.
void wait_for_transform(const tf2_ros::Buffer& tf, const std::string& target,
                        const std::string& source, const ros::Time& stamp, double patience);

/// tf's own words for why it cannot tell, with the remedy where it lags behind.
std::string tf_fault(const tf2::TransformException& error);

}  // namespace mbncc::nodelets
