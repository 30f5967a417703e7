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

constexpr double kSameStamp = 1e-6;  // [s] stamps of lessons were converted to double
constexpr int kPairs = 3;  // successive images with a calibration of their own, from which on each
                           // is expected to have one
constexpr std::chrono::seconds kPatience{1};  // for the next image with a calibration of its own
constexpr std::chrono::seconds kSettled{2};   // after which a calibration that changed is in force
constexpr double kDisorder = 0.05;            // [s] by which stamps go back only with the clock
constexpr std::size_t kMostStored = 100;      // more than the images that wait for a search

/// The serialized calibration without its header, because NaN would differ from itself.
std::vector<std::uint8_t> content_of(CameraInfo info) {
  namespace ser = ros::serialization;
  info.header = std_msgs::Header();
  std::vector<std::uint8_t> bytes(ser::serializationLength(info));
  ser::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ser::serialize(stream, info);
  return bytes;
}

/// Whether all of these calibrations are equal.
template <class Infos>
bool are_equal(const Infos& infos) {
  const auto content = content_of(*infos.front().info);
  return std::all_of(infos.begin() + 1, infos.end(),
                     [&](const auto& received) { return content_of(*received.info) == content; });
}

bool is_before(const ros::Time& a, const ros::Time& b) {
  return b.toSec() - a.toSec() > kSameStamp;  // a difference of ros::Time may throw
}

bool is_same(const ros::Time& a, const ros::Time& b) {
  return !is_before(a, b) && !is_before(b, a);
}

}  // namespace

void CameraInfoHistory::add(const CameraInfoConstPtr& info, Clock::time_point now) {
  const auto of_same_images = [&](const Received& other) {
    return other.info->header.frame_id == info->header.frame_id &&
           image_size(*other.info) == image_size(*info);
  };
  const auto stamp = [](const CameraInfoConstPtr& one) { return one->header.stamp.toSec(); };
  const auto last = std::find_if(received_.rbegin(), received_.rend(), of_same_images);
  if (last != received_.rend() && stamp(last->info) - stamp(info) > kDisorder)
    received_.erase(std::remove_if(received_.begin(), received_.end(),
                                   [&](const Received& other) {
                                     return of_same_images(other) &&
                                            stamp(other.info) > stamp(info);
                                   }),
                    received_.end());
  received_.push_back({info, now});
  if (received_.size() > kMostStored) received_.pop_front();
}

void CameraInfoHistory::clear() {
  received_.clear();
  pairs_ = 0;
  lacking_since_.reset();
}

bool CameraInfoHistory::is_awaited(const ros::Time& stamp) const {
  return pairs_ >= kPairs &&
         std::all_of(received_.begin(), received_.end(), [&](const Received& received) {
           return is_before(received.info->header.stamp, stamp);
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
  std::vector<Received> fitting;
  for (const auto& received : received_)
    if (!has_expired(received, now) && received.info->header.frame_id == header.frame_id &&
        image_size(*received.info) == size)
      fitting.push_back(received);
  const auto exact = std::find_if(fitting.rbegin(), fitting.rend(), [&](const Received& received) {
    return is_same(received.info->header.stamp, header.stamp);
  });
  if (exact != fitting.rend()) {
    note_pair(header.stamp);
    return exact->info;
  }
  // An image given with a goal may be older than all of them.
  const bool is_live = !fitting.empty() && header.stamp > fitting.front().info->header.stamp;
  if (is_live && lacks_its_own(now)) return nullptr;
  return of_neighbours(fitting, header.stamp, now);
}

void CameraInfoHistory::note_pair(const ros::Time& stamp) {
  if (!is_same(stamp, last_pair_)) ++pairs_;
  last_pair_ = stamp;
  lacking_since_.reset();
}

/// Whether an image without a calibration of its own has to wait for the next one that has one.
bool CameraInfoHistory::lacks_its_own(Clock::time_point now) {
  if (pairs_ >= kPairs && !lacking_since_) lacking_since_ = now;
  if (lacking_since_ && now - *lacking_since_ < kPatience) return true;
  pairs_ = 0;
  lacking_since_.reset();
  return false;
}

CameraInfoConstPtr CameraInfoHistory::of_neighbours(const std::vector<Received>& fitting,
                                                    const ros::Time& stamp, Clock::time_point now) {
  const auto after = std::find_if(fitting.begin(), fitting.end(), [&](const Received& received) {
    return received.info->header.stamp > stamp;
  });
  const bool settled =
      after == fitting.end() && !fitting.empty() && now - fitting.back().at > kSettled;
  const std::ptrdiff_t before = settled ? 1 : 2;
  const std::vector<Received> neighbours(after - std::min(before, after - fitting.begin()),
                                         after == fitting.end() ? after : after + 1);
  return neighbours.empty() || !are_equal(neighbours) ? nullptr : neighbours.back().info;
}

}  // namespace mbncc::nodelets
