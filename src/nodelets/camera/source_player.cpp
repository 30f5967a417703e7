// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/source_player.hpp"

#include <ros/console.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using Clock = SourcePlayer::Clock;
using Seconds = SourcePlayer::Seconds;

constexpr Seconds kFirstRetry{0.5}, kLongestRetry{8};  // pauses before reopening; each doubles
constexpr Seconds kPollInterval{0.05};                 // between checks for a subscriber or a clock
constexpr double kFolderRate = 10;                     // [Hz] of a source without a known rate

Clock::duration ticks(Seconds seconds) {
  return std::chrono::duration_cast<Clock::duration>(seconds);
}

}  // namespace

SourcePlayer::SourcePlayer(const CameraConfig& config, Callbacks callbacks)
    : config_(config),
      name_(without_secrets(config.source)),
      callbacks_(std::move(callbacks)),
      retry_(kFirstRetry) {}

void SourcePlayer::step() {
  try {
    try_step();
  } catch (const std::exception& error) {
    close(error.what());
  }
}

void SourcePlayer::try_step() {
  if (at_end_) return callbacks_.pause(kLongestRetry);
  if (!source_) open();
  // A folder or video waits for a subscriber and for the clock, so that no image is lost.
  if (!source_->is_live() && (!callbacks_.has_listener() || !has_new_stamp()))
    return callbacks_.pause(kPollInterval);
  play();
}

void SourcePlayer::open() {
  source_ = callbacks_.open();
  ROS_INFO("Opened %s", name_.c_str());
  health_.set_state(DiagnosticStatus::OK, "open");
  due_ = callbacks_.steady_time();
}

void SourcePlayer::close(const std::string& reason) {
  source_.reset();
  health_.count(&Counts::failures);
  health_.set_state(DiagnosticStatus::ERROR, reason);
  ROS_WARN("%s; trying again in %.1f s", reason.c_str(), retry_.count());
  callbacks_.pause(retry_);
  retry_ = std::min(2 * retry_, kLongestRetry);
}

bool SourcePlayer::has_new_stamp() const {
  const ros::Time now = callbacks_.time();
  return !now.isZero() && now != last_stamp_;
}

void SourcePlayer::play() {
  if (!source_->is_live()) wait_until_due();
  if (!source_->grab()) return end();
  const ros::Time stamp = callbacks_.time();
  retry_ = kFirstRetry;
  if (stamp.isZero() || stamp == last_stamp_) return health_.count(&Counts::unstamped);
  if (!callbacks_.has_listener()) return;
  const cv::Mat image = retrieve();
  if (image.empty()) return;
  refuse_frozen(image);
  last_stamp_ = stamp;
  callbacks_.publish(image, stamp);
  health_.count(&Counts::published);
}

void SourcePlayer::end() {
  at_end_ = true;
  const std::string advice = "loop (cell.launch loop:=true) plays it again and again";
  health_.set_state(DiagnosticStatus::WARN, "finished; " + advice);
  ROS_WARN("%s has ended, and no more images follow; %s", name_.c_str(), advice.c_str());
}

/// Returns an empty image and logs a warning if the image cannot be read.
cv::Mat SourcePlayer::retrieve() {
  try {
    return source_->retrieve();
  } catch (const FileError& error) {
    health_.count(&Counts::unreadable);
    ROS_WARN("%s", error.what());
    return {};
  }
}

/// Throws FileError if a live source repeats one image; recordings may.
void SourcePlayer::refuse_frozen(const cv::Mat& image) {
  if (!config_.detect_frozen || !source_->is_live() || !frozen_.update(image)) return;
  health_.count(&Counts::frozen);
  throw FileError(name_,
                  "the image is frozen; check the camera, or set detect_frozen to false if this "
                  "source may repeat images exactly");
}

void SourcePlayer::wait_until_due() {
  const double wanted = config_.frame_rate > 0 ? config_.frame_rate : source_->rate();
  const Clock::time_point now = callbacks_.steady_time();
  if (due_ > now) callbacks_.pause(due_ - now);
  // After a delay, images are not played faster to catch up.
  due_ = std::max(due_, now) + ticks(Seconds(1 / (wanted > 0 ? wanted : kFolderRate)));
}

}  // namespace mbncc::nodelets
