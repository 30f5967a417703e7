// SPDX-License-Identifier: BSD-3-Clause
// Composition of pose messages, each the pose of a frame in its parent.
#pragma once

#include <geometry_msgs/Pose.h>

namespace mbncc::nodelets {

/// The pose of C in A, from that of B in A and that of C in B.
geometry_msgs::Pose compose(const geometry_msgs::Pose& b_in_a, const geometry_msgs::Pose& c_in_b);

/// The pose of A in B, from that of B in A.
geometry_msgs::Pose inverse(const geometry_msgs::Pose& b_in_a);

/// Whether no coordinate is infinite or NaN.
bool is_finite(const geometry_msgs::Pose& pose);

/// Half a turn about x, which reverses the frame's y and z axes.
geometry_msgs::Pose half_turn_about_x();

}  // namespace mbncc::nodelets
