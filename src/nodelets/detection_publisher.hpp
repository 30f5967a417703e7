// Everything that goes out about a searched picture: detections, tf, overlay, markers, and the
// STALE messages when pictures fail to come.
#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <opencv2/core.hpp>
#include <string>

#include "nodelets/detection_pipeline.hpp"
#include "nodelets/tf_sender.hpp"

namespace mbncc::nodelets {

class DetectionPublisher {
 public:
  /// `listeners_changed` is called when somebody subscribes or goes.
  DetectionPublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                     const std::function<void()>& listeners_changed);

  /// Somebody hears detections, overlay or markers.
  bool has_listeners() const;

  /// `tf`: send the frames of confirmed instances, too. What has become too old during the search
  /// is no longer confirmed. Returns the latency [s].
  double publish(Detections detections, const cv::Mat& picture, bool tf);

  /// An empty array of status STALE, stamped now.
  void publish_stale(const std::string& message);

  /// The clock has jumped back.
  void reset() { tf_.reset(); }

 private:
  ros::Publisher detections_, overlay_, markers_;
  TfSender tf_;
};

}  // namespace mbncc::nodelets
