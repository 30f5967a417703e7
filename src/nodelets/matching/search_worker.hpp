// SPDX-License-Identifier: BSD-3-Clause
// Searches the stream of pictures on a thread of its own: newest first, each once, none too old.
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

/// What a search works with; all of it outlives the worker.
struct SearchTools {
  const LiveSettings& settings;
  const LiveMatcher& matcher;
  PictureSearch& pipeline;
  const CameraInput& camera;
  DetectionPublisher& publisher;
};

class SearchWorker {
 public:
  explicit SearchWorker(const SearchTools& tools);
  ~SearchWorker();

  /// Hands over a picture; never blocks, the newest wins.
  void put(const sensor_msgs::ImageConstPtr& image);

  /// Called now and then: publishes STALE when pictures are expected but fail to come.
  void look_for_silence(bool expected);

  /// What was seen before no longer counts, nor does a picture that has not been published yet.
  /// Silence counts from now.
  void begin_anew();

  SearchStatistics statistics() const { return statistics_.get(); }

 private:
  void work();
  void search(const sensor_msgs::Image& image);
  void publish(const Detections& detections, const cv::Mat& picture);
  bool admit(const std_msgs::Header& header);
  void start_over();
  void refuse(const std::string& fault);
  void note_answer(const ros::Time& stamp);
  void fail(const sensor_msgs::Image& image, const std::string& reason);
  std::string reason_of_silence() const;

  const SearchTools tools_;
  SharedStatistics statistics_;
  StaleWatch silence_;
  Mailbox<sensor_msgs::ImageConstPtr> mailbox_;
  std::atomic<unsigned> era_{0};  // begins anew with every begin_anew()
  std::atomic<bool> searching_{false};
  // Of the worker thread alone.
  unsigned pipeline_era_ = 0;
  SearchRequest request_;
  StampGate gate_;
  RateLimit rate_;  // of pictures that something was published about
  std::thread worker_;
};

}  // namespace mbncc::nodelets
