// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/common/camera_info_history.hpp"

#include <ros/serialization.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {
namespace {

using sensor_msgs::CameraInfo;
using sensor_msgs::CameraInfoConstPtr;

constexpr std::size_t kMostStored = 100;  // more than the images that wait for a search

/// The serialized calibration without its header, because NaN would differ from itself.
std::vector<std::uint8_t> content_of(CameraInfo info) {
  namespace ser = ros::serialization;
  info.header = std_msgs::Header();
  std::vector<std::uint8_t> bytes(ser::serializationLength(info));
  ser::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ser::serialize(stream, info);
  return bytes;
}

bool are_equal(const std::vector<CameraInfoConstPtr>& infos) {
  const auto content = content_of(*infos.front());
  return std::all_of(infos.begin() + 1, infos.end(),
                     [&](const CameraInfoConstPtr& info) { return content_of(*info) == content; });
}

}  // namespace

void CameraInfoHistory::add(const CameraInfoConstPtr& info, Clock::time_point now) {
  received_.push_back({info, now});
  if (received_.size() > kMostStored) received_.pop_front();
}

void CameraInfoHistory::clear() {
  received_.clear();
  paired_ = false;
}

bool CameraInfoHistory::is_awaited(const ros::Time& stamp) const {
  return paired_ && std::all_of(received_.begin(), received_.end(), [&](const Received& received) {
           return received.info->header.stamp < stamp;
         });
}

bool CameraInfoHistory::has_expired(const Received& received, Clock::time_point now) const {
  return now - received.at > max_age_;
}

CameraInfoConstPtr CameraInfoHistory::newest(Clock::time_point now) const {
  return received_.empty() || has_expired(received_.back(), now) ? nullptr : received_.back().info;
}

CameraInfoConstPtr CameraInfoHistory::of_image(const std_msgs::Header& header, cv::Size size,
                                               Clock::time_point now) {
  std::vector<CameraInfoConstPtr> fitting;
  for (const auto& received : received_)
    if (!has_expired(received, now) && received.info->header.frame_id == header.frame_id &&
        image_size(*received.info) == size)
      fitting.push_back(received.info);
  const auto exact = std::find_if(
      fitting.rbegin(), fitting.rend(),
      [&](const CameraInfoConstPtr& info) { return info->header.stamp == header.stamp; });
  // An image given with a goal may be older than all of them.
  const bool is_live = !fitting.empty() && header.stamp > fitting.front()->header.stamp;
  const bool was_paired = is_live && paired_;
  if (exact != fitting.rend() || is_live) paired_ = exact != fitting.rend();
  if (exact != fitting.rend()) return *exact;
  if (was_paired) return nullptr;
  const auto after = std::find_if(
      fitting.begin(), fitting.end(),
      [&](const CameraInfoConstPtr& info) { return info->header.stamp > header.stamp; });
  const std::vector<CameraInfoConstPtr> neighbours(
      after - std::min<std::ptrdiff_t>(2, after - fitting.begin()),
      after == fitting.end() ? after : after + 1);
  if (neighbours.empty() || !are_equal(neighbours)) return nullptr;
  return neighbours.back();
}

}  // namespace mbncc::nodelets
