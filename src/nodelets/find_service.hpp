// The find_objects service: one search, on a given picture or on the next live ones.
#pragma once

#include <mbncc_vision/FindObjects.h>
#include <ros/node_handle.h>
#include <tf2_ros/buffer.h>

#include <functional>

#include "mbncc/config/matching_node_config.hpp"
#include "nodelets/camera_input.hpp"
#include "nodelets/detection_pipeline.hpp"
#include "nodelets/live_matcher.hpp"
#include "nodelets/picture_wait.hpp"

namespace mbncc::nodelets {

/// What the service works with; all of it outlives the service.
struct FindTools {
  const MatchingNodeConfig& config;
  const LiveMatcher& matcher;
  const tf2_ros::Buffer& tf;
  const CameraInput& camera;
  PictureWait& pictures;
  /// A live picture is wanted, or no longer.
  std::function<void()> wants_changed;
};

class FindService {
 public:
  using Request = mbncc_vision::FindObjects::Request;
  using Response = mbncc_vision::FindObjects::Response;

  /// A call may wait for pictures, so `node` needs a callback queue of its own.
  FindService(ros::NodeHandle node, const FindTools& tools);

 private:
  bool on_call(Request& request, Response& response);
  Detections find(const Request& request) const;
  Detections find_live(const Request& request, DetectionPipeline& pipeline) const;
  ReceivedPicture next_picture(const ros::Time& after, double timeout) const;

  const FindTools tools_;
  ros::ServiceServer server_;
};

}  // namespace mbncc::nodelets
