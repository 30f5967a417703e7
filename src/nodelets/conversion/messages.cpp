// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/messages.hpp"

#include <mbncc_vision/LearnObjectGoal.h>
#include <tf2/LinearMath/Matrix3x3.h>
#include <tf2/LinearMath/Quaternion.h>
#include <tf2_geometry_msgs/tf2_geometry_msgs.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string>

#include "mbncc/symmetry.hpp"
#include "nodelets/conversion/images.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr int kThumbnailSide = 160;  // [px]
constexpr double kFarthestPixel = 1 << 15;

cv::Mat thumbnail_of(const View& view) {
  const int side = std::max(view.template_image.cols, view.template_image.rows);
  if (side <= kThumbnailSide) return view.template_image;
  const double factor = static_cast<double>(kThumbnailSide) / side;
  const cv::Size size(std::max(1, static_cast<int>(view.template_image.cols * factor)),
                      std::max(1, static_cast<int>(view.template_image.rows * factor)));
  cv::Mat small;
  cv::resize(view.template_image, small, size, 0, 0, cv::INTER_AREA);
  return small;
}

geometry_msgs::Pose unknown_pose() {
  geometry_msgs::Pose pose;
  pose.position.x = pose.position.y = pose.position.z = kNaN;
  pose.orientation.x = pose.orientation.y = pose.orientation.z = pose.orientation.w = kNaN;
  return pose;
}

geometry_msgs::Quaternion quaternion_of(const cv::Matx33d& r) {
  tf2::Quaternion q;
  tf2::Matrix3x3(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2))
      .getRotation(q);
  return tf2::toMsg(q);
}

geometry_msgs::Polygon largest_outline(const View& view) {
  const auto all = outlines(view);
  return all.empty() ? geometry_msgs::Polygon{} : to_msg(all.front());
}

}  // namespace

geometry_msgs::Pose2D to_msg(const Pose2D& pose) {
  geometry_msgs::Pose2D message;
  message.x = pose.x;
  message.y = pose.y;
  message.theta = pose.theta;
  return message;
}

geometry_msgs::Polygon to_msg(const std::vector<cv::Point2f>& polygon) {
  geometry_msgs::Polygon message;
  message.points.resize(polygon.size());
  std::transform(polygon.begin(), polygon.end(), message.points.begin(), [](cv::Point2f corner) {
    geometry_msgs::Point32 point;
    point.x = corner.x;
    point.y = corner.y;
    return point;
  });
  return message;
}

geometry_msgs::Pose to_msg(const Grasp& grasp) {
  geometry_msgs::Pose message;
  message.position.x = grasp.position[0];
  message.position.y = grasp.position[1];
  message.position.z = grasp.position[2];
  message.orientation.x = grasp.orientation[0];
  message.orientation.y = grasp.orientation[1];
  message.orientation.z = grasp.orientation[2];
  message.orientation.w = grasp.orientation[3];
  return message;
}

geometry_msgs::PoseWithCovariance to_msg(const PlatformPose& pose) {
  geometry_msgs::PoseWithCovariance message;
  message.pose.position.x = pose.position[0];
  message.pose.position.y = pose.position[1];
  message.pose.position.z = pose.position[2];
  message.pose.orientation = quaternion_of(pose.rotation);
  std::copy(pose.covariance.val, pose.covariance.val + 36, message.covariance.begin());
  return message;
}

sensor_msgs::RegionOfInterest to_msg(const cv::Rect& region) {
  sensor_msgs::RegionOfInterest message;
  message.x_offset = static_cast<std::uint32_t>(std::max(0, region.x));
  message.y_offset = static_cast<std::uint32_t>(std::max(0, region.y));
  message.width = static_cast<std::uint32_t>(std::max(0, region.width));
  message.height = static_cast<std::uint32_t>(std::max(0, region.height));
  return message;
}

mbncc_vision::LearnQuality to_msg(const Quality& quality) {
  mbncc_vision::LearnQuality message;
  message.verdict = static_cast<std::uint8_t>(quality.verdict);
  message.reasons = quality.reasons;
  message.advice = quality.advice;
  message.area = static_cast<float>(quality.area);
  message.fill = static_cast<float>(quality.fill);
  message.contrast = static_cast<float>(quality.contrast);
  message.edge_agreement = static_cast<float>(quality.edge_agreement);
  message.change_agreement = static_cast<float>(quality.change_agreement);
  message.outline_probability = static_cast<float>(quality.outline_probability);
  message.self_score = static_cast<float>(quality.self_score);
  message.self_error = static_cast<float>(quality.self_error);
  message.runner_up = static_cast<float>(quality.runner_up);
  message.angle_halfwidth = static_cast<float>(quality.angle_halfwidth);
  message.symmetry = static_cast<std::uint8_t>(quality.symmetry);
  message.confusable_with = quality.confusable_with;
  message.confusable_score = static_cast<float>(quality.confusable_score);
  message.search_time = static_cast<float>(quality.search_time);
  return message;
}

mbncc_vision::LearnedObject to_msg(const ObjectModel& model, bool with_thumbnail) {
  mbncc_vision::LearnedObject message;
  message.name = model.name;
  message.label = model.label;
  message.revision = model.revision;
  message.views = static_cast<std::uint32_t>(model.views.size());
  if (model.learned_at > 0) message.learned_at.fromSec(model.learned_at);
  message.taught_by = model.taught_by;
  message.enabled = model.enabled;
  message.metres_per_pixel = model.metres_per_pixel;
  message.object_height = model.object_height;
  message.size = size_of(model);
  message.has_grasp = model.grasp.has_value();
  if (model.grasp) message.grasp = to_msg(*model.grasp);
  message.min_score = static_cast<float>(model.min_score.value_or(0));
  message.symmetry = symmetry_to_msg(model.symmetry);
  message.quality = to_msg(model.quality);
  if (model.views.empty()) return message;
  const View& view = model.views.front();
  message.image_width = static_cast<std::uint32_t>(view.image_size.width);
  message.image_height = static_cast<std::uint32_t>(view.image_size.height);
  message.reference = to_msg(view.reference);
  message.outline = largest_outline(view);
  if (with_thumbnail) message.thumbnail = encode_image(thumbnail_of(view));
  return message;
}

mbncc_vision::DetectedObject to_msg(const Match& match, const ObjectModel* model) {
  mbncc_vision::DetectedObject message;
  message.name = match.name;
  message.revision = match.revision;
  message.state =
      match.ambiguous ? mbncc_vision::DetectedObject::AMBIGUOUS : mbncc_vision::DetectedObject::NEW;
  message.score = static_cast<float>(match.score);
  message.similarity = static_cast<float>(match.similarity);
  message.scale = static_cast<float>(match.scale);
  message.margin_place = static_cast<float>(match.margin_place);
  message.margin_angle = static_cast<float>(match.margin_angle);
  message.visible = static_cast<float>(match.visible);
  message.image_pose = to_msg(match.pose);
  std::copy(match.covariance.val, match.covariance.val + 9, message.image_pose_covariance.begin());
  message.pose_valid = false;
  message.pose.pose = unknown_pose();
  message.size = size_of(model != nullptr ? *model : ObjectModel{});
  message.symmetry = static_cast<std::uint8_t>(match.symmetry);
  message.outline = to_msg(match.outline);
  message.reasons = match.reasons;
  return message;
}

std::optional<Pose2D> from_msg(const geometry_msgs::Pose2D& pose) {
  // False for NaN.
  const auto is_near = [](double pixels) { return std::abs(pixels) <= kFarthestPixel; };
  if (!is_near(pose.x) || !is_near(pose.y) || !std::isfinite(pose.theta)) return {};
  return Pose2D{pose.x, pose.y, pose.theta};
}

std::optional<Grasp> from_msg(const geometry_msgs::Pose& grasp) {
  const auto& p = grasp.position;
  const auto& q = grasp.orientation;
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  const double reach = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  if (!std::isfinite(p.x + p.y + p.z) || reach > kLongestLength || !(std::abs(norm - 1) < 0.01))
    return {};
  return Grasp{{{p.x, p.y, p.z}}, {{q.x / norm, q.y / norm, q.z / norm, q.w / norm}}};
}

std::optional<std::vector<cv::Point2f>> from_msg(const geometry_msgs::Polygon& polygon) {
  std::vector<cv::Point2f> corners;
  for (const auto& point : polygon.points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return {};
    corners.emplace_back(point.x, point.y);
  }
  return corners;
}

std::optional<cv::Rect> from_msg(const sensor_msgs::RegionOfInterest& region, cv::Size size) {
  if (region.width == 0 && region.height == 0) return cv::Rect{};
  const std::uint64_t right = std::uint64_t{region.x_offset} + region.width;
  const std::uint64_t bottom = std::uint64_t{region.y_offset} + region.height;
  if (region.width == 0 || region.height == 0 || right > static_cast<std::uint64_t>(size.width) ||
      bottom > static_cast<std::uint64_t>(size.height))
    return {};
  return cv::Rect(static_cast<int>(region.x_offset), static_cast<int>(region.y_offset),
                  static_cast<int>(region.width), static_cast<int>(region.height));
}

std::uint8_t symmetry_to_msg(std::optional<int> symmetry) {
  using Goal = mbncc_vision::LearnObjectGoal;
  if (!symmetry) return Goal::SYMMETRY_AUTO;
  if (*symmetry == 0) return Goal::SYMMETRY_ROUND;
  return static_cast<std::uint8_t>(*symmetry);
}

std::optional<int> symmetry_from_msg(std::uint8_t symmetry) {
  using Goal = mbncc_vision::LearnObjectGoal;
  if (symmetry == Goal::SYMMETRY_AUTO) return {};
  if (symmetry == Goal::SYMMETRY_ROUND) return 0;
  if (!is_declarable_symmetry(symmetry))
    throw std::invalid_argument("the symmetry " + std::to_string(symmetry) +
                                " does not exist; give 0 (auto), 1 (none), 2 to 12, or 255 "
                                "(round)");
  return symmetry;
}

geometry_msgs::Vector3 size_of(const ObjectModel& model) {
  geometry_msgs::Vector3 size;
  size.x = size.y = size.z = kNaN;
  if (model.views.empty() || !std::isfinite(model.metres_per_pixel)) return size;
  std::vector<cv::Point2f> points;
  for (const auto& outline : outlines(model.views.front()))
    points.insert(points.end(), outline.begin(), outline.end());
  if (points.empty()) return size;
  const auto by_x =
      std::minmax_element(points.begin(), points.end(), [](auto a, auto b) { return a.x < b.x; });
  const auto by_y =
      std::minmax_element(points.begin(), points.end(), [](auto a, auto b) { return a.y < b.y; });
  size.x = (by_x.second->x - by_x.first->x) * model.metres_per_pixel;
  size.y = (by_y.second->y - by_y.first->y) * model.metres_per_pixel;
  size.z = model.object_height;
  return size;
}

geometry_msgs::Polygon footprint_of(const ObjectModel& model) {
  if (model.views.empty() || !std::isfinite(model.metres_per_pixel)) return {};
  geometry_msgs::Polygon footprint = largest_outline(model.views.front());
  for (auto& corner : footprint.points) {
    corner.x = static_cast<float>(corner.x * model.metres_per_pixel);
    corner.y = static_cast<float>(corner.y * model.metres_per_pixel);
    corner.z = static_cast<float>(model.object_height);
  }
  return footprint;
}

const char* word_of(std::uint8_t state) {
  switch (state) {
    case mbncc_vision::DetectedObject::CONFIRMED:
      return "confirmed";
    case mbncc_vision::DetectedObject::AMBIGUOUS:
      return "ambiguous";
    case mbncc_vision::DetectedObject::HELD:
      return "held";
    default:
      return "not sure yet";
  }
}

}  // namespace mbncc::nodelets
