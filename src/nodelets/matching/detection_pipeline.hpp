// SPDX-License-Identifier: BSD-3-Clause
// Converts an image to a DetectedObjectArray: search, tracking, conversion to metres, message.
#pragma once

#include <mbncc_vision/DetectedObjectArray.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2_ros/buffer.h>

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/cell/pose_average.hpp"
#include "mbncc/cell/tracker.hpp"
#include "mbncc/cell/video_search.hpp"
#include "mbncc/config/matching_node_config.hpp"
#include "nodelets/conversion/calibration.hpp"
#include "nodelets/matching/live_matcher.hpp"

namespace mbncc::nodelets {

/// The detections in one image, before conversion to messages.
struct TrackedImage {
  Found found;
  std::vector<TrackedMatch> matches;
};

/// The message about an image, and the library that was searched.
struct Detections {
  mbncc_vision::DetectedObjectArray array;
  SharedLibrary::Snapshot library;
};

/// An image with its stamp, frame and calibration.
struct ReceivedImage {
  cv::Mat image;  ///< CV_8UC3
  std_msgs::Header header;
  sensor_msgs::CameraInfoConstPtr camera_info;  ///< null: no calibration fits
};

/// The tracker's settings, taken from those of the nodelet.
TrackerConfig tracker_config(const MatchingNodeConfig& config);

/// Searches one image after the other.
class ImageSearch {
 public:
  virtual ~ImageSearch() = default;

  /// The settings apply from the next image on. Throws std::invalid_argument if the tracker refuses
  /// them.
  virtual void configure(const MatchingNodeConfig& config) = 0;

  virtual Detections process(const ReceivedImage& received, const SearchRequest& request) = 0;

  /// Invalidates earlier detections: every instance must be confirmed again. One that has not moved
  /// keeps its id.
  virtual void interrupt() = 0;

  /// Drops all instances.
  virtual void reset() = 0;
};

class DetectionPipeline : public ImageSearch {
 public:
  /// `matcher` and `tf` must outlive the pipeline.
  DetectionPipeline(const MatchingNodeConfig& config, const LiveMatcher& matcher,
                    const tf2_ros::Buffer& tf);

  /// The settings of video search and averaging stay those of the constructor.
  void configure(const MatchingNodeConfig& config) override;

  Detections process(const ReceivedImage& received, const SearchRequest& request) override;

  /// The two halves of process().
  TrackedImage track(const ReceivedImage& received, const SearchRequest& request);
  Detections describe(const ReceivedImage& received, const TrackedImage& tracked) const;

  /// The next image is searched completely.
  void interrupt() override;

  void reset() override;

 private:
  mbncc_vision::DetectedObject describe(const TrackedMatch& tracked, const ObjectModel* model,
                                        const Calibration& calibration) const;
  /// Describes an instance that is not in this image but was in an earlier one. Its pose is invalid
  /// if tf no longer knows where the platform was then.
  mbncc_vision::DetectedObject describe_held(const TrackedMatch& tracked, const ObjectModel* model,
                                             const ReceivedImage& received,
                                             const Calibration& now) const;
  void wait_for_tf(const std_msgs::Header& header) const;
  /// Converts the poses to target_frame. Returns the fault; "" if there is none.
  std::string to_target_frame(mbncc_vision::DetectedObjectArray& array) const;

  MatchingNodeConfig config_;
  const LiveMatcher& matcher_;
  const tf2_ros::Buffer& tf_;
  VideoSearch video_;
  InstanceTracker tracker_;
  PoseAverage average_;
};

}  // namespace mbncc::nodelets
