// SPDX-License-Identifier: BSD-3-Clause
// The find_objects service: one search in a given image or in the next live ones.
#pragma once

#include <mbncc_vision/FindObjects.h>
#include <ros/callback_queue.h>
#include <ros/node_handle.h>
#include <ros/spinner.h>
#include <tf2_ros/buffer.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <mutex>

#include "nodelets/common/camera_input.hpp"
#include "nodelets/matching/detection_pipeline.hpp"
#include "nodelets/matching/image_wait.hpp"
#include "nodelets/matching/live_matcher.hpp"
#include "nodelets/matching/live_settings.hpp"

namespace mbncc::nodelets {

/// Dependencies of the service; all must outlive it.
struct FindTools {
  const LiveSettings& settings;
  const LiveMatcher& matcher;
  const tf2_ros::Buffer& tf;
  CameraInput& camera;
  ImageWait& images;
  /// Called when live images become needed or unneeded.
  std::function<void()> wants_changed;
};

class FindService {
 public:
  using Request = mbncc_vision::FindObjects::Request;
  using Response = mbncc_vision::FindObjects::Response;

  /// Up to four calls at a time are accepted, and searched one after the other; further calls
  /// return BUSY at once.
  FindService(ros::NodeHandle node, const FindTools& tools);
  /// Calls close().
  ~FindService() { close(); }

  /// Accepts no more calls and waits for running ones. ImageWait::close() ends their waiting for
  /// images.
  void close();

 private:
  using Clock = std::chrono::steady_clock;

  bool on_call(Request& request, Response& response);
  Detections find(const Request& request);
  Detections find_given(const Request& request, const MatchingNodeConfig& config,
                        DetectionPipeline& pipeline, Clock::time_point deadline);
  Detections find_live(const Request& request, const MatchingNodeConfig& config,
                       DetectionPipeline& pipeline, Clock::time_point deadline);
  ReceivedImage next_image(const ros::Time& after, int white_level,
                           Clock::time_point deadline) const;
  std::unique_lock<std::timed_mutex> lock_search(Clock::time_point deadline);

  const FindTools tools_;
  std::atomic<int> calls_{0};   // number of running calls
  std::timed_mutex searching_;  // one search at a time, in parallel to that of the stream
  ros::CallbackQueue queue_;
  ros::AsyncSpinner spinner_;
  ros::ServiceServer server_;
};

}  // namespace mbncc::nodelets
