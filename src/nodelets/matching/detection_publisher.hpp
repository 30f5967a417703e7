// SPDX-License-Identifier: BSD-3-Clause
// Publishes the results of a searched image: detections, tf, overlay and markers, and messages
// without objects if images stop or cannot be searched.
#pragma once

#include <geometry_msgs/PoseArray.h>
#include <ros/node_handle.h>
#include <tf2_ros/transform_broadcaster.h>

#include <cstdint>
#include <functional>
#include <opencv2/core.hpp>
#include <string>

#include "nodelets/conversion/object_frames.hpp"
#include "nodelets/matching/detection_pipeline.hpp"

namespace mbncc::nodelets {

/// The poses in metres of graspable objects, in the array's order.
geometry_msgs::PoseArray confirmed_poses(const mbncc_vision::DetectedObjectArray& detections);

class DetectionPublisher {
 public:
  /// `listeners_changed` is called when a subscriber connects or disconnects.
  DetectionPublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                     const std::function<void()>& listeners_changed);

  /// Whether any of the topics has a subscriber.
  bool has_listeners() const;

  /// Computes the largest similarity at each pixel of an image, CV_32FC1. Called only if a
  /// subscriber needs it.
  using ScoreMap = std::function<cv::Mat()>;

  /// Publishes the detections and, with `tf`, the frames of confirmed instances. Objects that have
  /// become too old during the search are no longer confirmed. Sets the latency.
  void publish(mbncc_vision::DetectedObjectArray& array, bool tf);

  /// Publishes what is drawn for display; with `scores_under_overlay`, the overlay over the score
  /// map.
  void publish_images(const mbncc_vision::DetectedObjectArray& array, const cv::Mat& image,
                      const ScoreMap& score_map, bool scores_under_overlay);

  /// Publishes an array without objects, of status STALE or SEARCH_FAILED, which invalidates
  /// earlier messages.
  void publish_fault(std::uint8_t status, const std_msgs::Header& header,
                     const std::string& message);

  /// Call this when the clock has jumped back.
  void reset() { frames_.reset(); }

 private:
  ros::Publisher detections_, poses_, overlay_, overlay_jpeg_, score_map_, markers_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ObjectFrames frames_;
};

}  // namespace mbncc::nodelets
