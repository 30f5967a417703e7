// SPDX-License-Identifier: BSD-3-Clause
// Searches the image stream on a separate thread: the newest images, each once, none too old.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/Image.h>

#include <atomic>
#include <string>
#include <thread>

#include "mbncc/cell/rate_limit.hpp"
#include "mbncc/cell/stamp_gate.hpp"
#include "nodelets/common/camera_input.hpp"
#include "nodelets/common/mailbox.hpp"
#include "nodelets/matching/detection_pipeline.hpp"
#include "nodelets/matching/detection_publisher.hpp"
#include "nodelets/matching/live_settings.hpp"
#include "nodelets/matching/search_statistics.hpp"
#include "nodelets/matching/stale_watch.hpp"

namespace mbncc::nodelets {

/// Dependencies of a search; all outlive the worker.
struct SearchTools {
  const LiveSettings& settings;
  const LiveMatcher& matcher;
  ImageSearch& pipeline;
  CameraInput& camera;
  DetectionPublisher& publisher;
};

class SearchWorker {
 public:
  explicit SearchWorker(const SearchTools& tools);
  ~SearchWorker();

  /// Queues an image; never blocks. If queue_size images wait, the oldest is dropped.
  void put(const sensor_msgs::ImageConstPtr& message);

  /// Call this periodically. Publishes STALE if expected images do not arrive.
  void check_stale(bool expected);

  /// Invalidates earlier detections and images whose results are not published yet. The time
  /// without images counts from now.
  void invalidate_detections();

  SearchStatistics statistics() const { return statistics_.get(); }

 private:
  void work();
  void search(const sensor_msgs::Image& message);
  bool publish(mbncc_vision::DetectedObjectArray& array, unsigned generation);
  void end_generation();
  bool admit(const std_msgs::Header& header);
  void reset_after_clock_jump();
  void refuse(const std::string& fault);
  void note_answer(const ros::Time& stamp);
  void fail(const sensor_msgs::Image& message, const std::string& reason);
  std::string reason_of_staleness() const;

  const SearchTools tools_;
  SharedStatistics statistics_;
  StaleWatch silence_;
  Mailbox<sensor_msgs::ImageConstPtr> mailbox_;
  std::mutex publishing_;                // nothing of an earlier generation is published
  std::atomic<unsigned> generation_{0};  // incremented when earlier detections become invalid
  std::atomic<bool> searching_{false};
  // Used by the worker thread only.
  unsigned pipeline_generation_ = 0;
  StampGate gate_;
  RateLimit rate_;  // counts images with a published message
  std::thread worker_;
};

}  // namespace mbncc::nodelets
