// SPDX-License-Identifier: BSD-3-Clause
// Converts the core's types to messages and back.
#pragma once

#include <geometry_msgs/Polygon.h>
#include <geometry_msgs/Pose2D.h>
#include <geometry_msgs/PoseWithCovariance.h>
#include <mbncc_vision/DetectedObject.h>
#include <mbncc_vision/LearnQuality.h>
#include <mbncc_vision/LearnedObject.h>
#include <sensor_msgs/RegionOfInterest.h>

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "mbncc/cell/platform.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::nodelets {

geometry_msgs::Pose2D to_msg(const Pose2D& pose);
geometry_msgs::Polygon to_msg(const std::vector<cv::Point2f>& polygon);
geometry_msgs::Pose to_msg(const Grasp& grasp);
geometry_msgs::PoseWithCovariance to_msg(const PlatformPose& pose);
sensor_msgs::RegionOfInterest to_msg(const cv::Rect& region);
mbncc_vision::LearnQuality to_msg(const Quality& quality);

/// `with_thumbnail`: adds an image of the first view of at most 160 x 160 px.
mbncc_vision::LearnedObject to_msg(const ObjectModel& model, bool with_thumbnail);

/// Fills in what is known from the image alone: the pose in metres is NaN, the state is NEW or
/// AMBIGUOUS, and there is no instance. `size` is that of `model`; NaN if this is null.
mbncc_vision::DetectedObject to_msg(const Match& match, const ObjectModel* model);

/// None if a number is not finite, or the magnitude of x or y exceeds 32768 px.
std::optional<Pose2D> from_msg(const geometry_msgs::Pose2D& pose);

/// None if a coordinate is not finite or beyond kLongestLength, or the length of the quaternion
/// is not within 0.01 of 1.
std::optional<Grasp> from_msg(const geometry_msgs::Pose& grasp);

/// None if a corner is not finite.
std::optional<std::vector<cv::Point2f>> from_msg(const geometry_msgs::Polygon& polygon);

/// Empty for 0 x 0; none if it is not inside an image of `size`, or has one side of 0.
std::optional<cv::Rect> from_msg(const sensor_msgs::RegionOfInterest& region, cv::Size size);

/// Converts a declared symmetry to one of LearnObject's constants SYMMETRY_..., and none to
/// SYMMETRY_AUTO.
std::uint8_t symmetry_to_msg(std::optional<int> symmetry);

/// The inverse of symmetry_to_msg(). Throws std::invalid_argument that names the allowed values for
/// any other value.
std::optional<int> symmetry_from_msg(std::uint8_t symmetry);

/// Extents [m] of the first view's map along the object's x and y, and the object's height [m] as
/// z; NaN if learned without scale.
geometry_msgs::Vector3 size_of(const ObjectModel& model);

/// The largest outline [m] of the first view at the height of the platform, in the object frame
/// with z into the platform; empty if learned without scale.
geometry_msgs::Polygon footprint_of(const ObjectModel& model);

/// Text that shows a value of DetectedObject::state to users.
const char* word_of(std::uint8_t state);

}  // namespace mbncc::nodelets
