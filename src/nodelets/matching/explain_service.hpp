// SPDX-License-Identifier: BSD-3-Clause
// The ~explain service: explains why objects are, or are not, found at a place in an image.
#pragma once

#include <mbncc_vision/ExplainPlace.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>

#include <functional>
#include <string>

#include "mbncc/config/matching_node_config.hpp"
#include "mbncc/miss/saved_miss.hpp"
#include "nodelets/matching/image_wait.hpp"
#include "nodelets/matching/live_matcher.hpp"

namespace mbncc::nodelets {

/// Dependencies of the service; all must outlive it.
struct ExplainTools {
  std::function<MatchingNodeConfig()> config;
  const LiveMatcher& matcher;
  ImageWait& images;
  std::function<void()> wants_changed;  ///< called when live images become needed or unneeded
};

class ExplainService {
 public:
  using Request = mbncc_vision::ExplainPlace::Request;
  using Response = mbncc_vision::ExplainPlace::Response;

  /// Calls run on a separate thread, one after the other.
  ExplainService(ros::NodeHandle private_node, const ExplainTools& tools);

 private:
  bool on_call(Request& request, Response& response);
  void explain(const Request& request, Response& response) const;
  sensor_msgs::Image live_image() const;
  /// Writes the case to a file in the library folder and returns its path.
  std::string save(const SavedMiss& miss) const;

  const ExplainTools tools_;
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  ros::ServiceServer server_;
};

}  // namespace mbncc::nodelets
