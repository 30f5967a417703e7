#include "nodelets/detection_publisher.hpp"

#include <sensor_msgs/Image.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>

#include "nodelets/images.hpp"
#include "nodelets/markers.hpp"
#include "nodelets/overlay.hpp"

namespace mbncc::nodelets {

using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

namespace {

void withdraw_outdated(DetectedObjectArray& array, const ros::Time& now) {
  for (auto& object : array.objects) {
    if (object.state != DetectedObject::CONFIRMED || now <= object.valid_until) continue;
    object.state = DetectedObject::NEW;
    object.child_frame_id.clear();
  }
}

}  // namespace

DetectionPublisher::DetectionPublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                                       const std::function<void()>& listeners_changed) {
  const ros::SubscriberStatusCallback changed =
      [listeners_changed](const ros::SingleSubscriberPublisher&) { listeners_changed(); };
  detections_ = node.advertise<DetectedObjectArray>("detected_objects", 1, changed, changed);
  overlay_ = private_node.advertise<sensor_msgs::Image>("overlay", 1, changed, changed);
  markers_ =
      private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, changed, changed);
}

bool DetectionPublisher::has_listeners() const {
  return detections_.getNumSubscribers() + overlay_.getNumSubscribers() +
             markers_.getNumSubscribers() >
         0;
}

double DetectionPublisher::publish(Detections detections, const cv::Mat& picture, bool tf) {
  DetectedObjectArray& array = detections.array;
  const ros::Time now = ros::Time::now();
  array.latency = static_cast<float>((now - array.header.stamp).toSec());
  withdraw_outdated(array, now);
  if (!tf)
    for (auto& object : array.objects) object.child_frame_id.clear();
  detections_.publish(array);
  if (tf) tf_.send(array, *detections.library);
  if (markers_.getNumSubscribers() > 0) markers_.publish(to_markers(array));
  if (overlay_.getNumSubscribers() > 0)
    overlay_.publish(encode_picture(draw_detections(picture, array), array.header));
  return array.latency;
}

void DetectionPublisher::publish_stale(const std::string& message) {
  DetectedObjectArray stale;
  stale.header.stamp = ros::Time::now();
  stale.status = DetectedObjectArray::STALE;
  stale.message = message;
  detections_.publish(stale);
}

}  // namespace mbncc::nodelets
