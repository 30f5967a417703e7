// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/detection_publisher.hpp"

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <visualization_msgs/MarkerArray.h>

#include "nodelets/conversion/images.hpp"
#include "nodelets/matching/frame_permission.hpp"
#include "nodelets/matching/graspable.hpp"
#include "nodelets/matching/markers.hpp"
#include "nodelets/matching/overlay.hpp"

namespace mbncc::nodelets {

using mbncc_vision::DetectedObjectArray;

geometry_msgs::PoseArray confirmed_poses(const DetectedObjectArray& detections) {
  geometry_msgs::PoseArray poses;
  poses.header = detections.header;
  for (const auto* object : graspable(detections)) poses.poses.push_back(object->pose.pose);
  return poses;
}

DetectionPublisher::DetectionPublisher(ros::NodeHandle node, ros::NodeHandle private_node,
                                       const std::function<void()>& listeners_changed) {
  const ros::SubscriberStatusCallback changed =
      [listeners_changed](const ros::SingleSubscriberPublisher&) { listeners_changed(); };
  detections_ = node.advertise<DetectedObjectArray>("detected_objects", 1, changed, changed);
  poses_ = private_node.advertise<geometry_msgs::PoseArray>("poses", 1, changed, changed);
  overlay_ = private_node.advertise<sensor_msgs::Image>("overlay", 1, changed, changed);
  overlay_jpeg_ =
      private_node.advertise<sensor_msgs::CompressedImage>("overlay_jpeg", 1, changed, changed);
  score_map_ = private_node.advertise<sensor_msgs::Image>("score_map", 1, changed, changed);
  markers_ =
      private_node.advertise<visualization_msgs::MarkerArray>("markers", 1, changed, changed);
}

bool DetectionPublisher::has_listeners() const {
  for (const auto* publisher :
       {&detections_, &poses_, &overlay_, &overlay_jpeg_, &score_map_, &markers_})
    if (publisher->getNumSubscribers() > 0) return true;
  return false;
}

void DetectionPublisher::publish(DetectedObjectArray& array, bool tf) {
  permit_frames(array, ros::Time::now(), tf);
  detections_.publish(array);
  poses_.publish(confirmed_poses(array));
  const auto transforms = frames_.transforms_of(array);
  if (!transforms.empty()) broadcaster_.sendTransform(transforms);
  if (markers_.getNumSubscribers() > 0) markers_.publish(to_markers(array));
}

void DetectionPublisher::publish_images(const DetectedObjectArray& array, const cv::Mat& image,
                                        const ScoreMap& score_map, bool scores_under_overlay) {
  const bool overlay = overlay_.getNumSubscribers() > 0;
  const bool jpeg = overlay_jpeg_.getNumSubscribers() > 0;
  const bool scores = score_map_.getNumSubscribers() > 0;
  if (!overlay && !jpeg && !scores) return;
  cv::Mat coloured;
  if (scores || scores_under_overlay) coloured = colour_score_map(score_map());
  if (scores) score_map_.publish(encode_image(coloured, array.header));
  if (!overlay && !jpeg) return;
  cv::Mat ground = image;
  if (scores_under_overlay) cv::addWeighted(image, 0.5, coloured, 0.5, 0, ground);
  const cv::Mat drawn = draw_detections(ground, array);
  if (overlay) overlay_.publish(encode_image(drawn, array.header));
  if (jpeg) overlay_jpeg_.publish(encode_jpeg(drawn, array.header));
}

void DetectionPublisher::publish_fault(std::uint8_t status, const std_msgs::Header& header,
                                       const std::string& message) {
  DetectedObjectArray array;
  array.header = header;
  array.status = status;
  array.message = message;
  detections_.publish(array);
  poses_.publish(confirmed_poses(array));
  markers_.publish(to_markers(array));  // deletes the markers: the objects may have been moved
}

}  // namespace mbncc::nodelets
