// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>

#include <string>

namespace mbncc::nodelets {

/// Calls `name` on a separate connection that stays open until the answer is read. With a
/// connection that is not persistent, roscpp may see the server hang up before it reads the answer,
/// and lose the call (github.com/ros/ros_comm/issues/1976).
template <class Service>
bool call_service(const std::string& name, Service& service) {
  ros::ServiceClient client = ros::NodeHandle().serviceClient<Service>(name, true);
  return client.isValid() && client.call(service);
}

}  // namespace mbncc::nodelets
