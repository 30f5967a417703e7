// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/scene_watch.hpp"

#include <algorithm>
#include <stdexcept>

#include "cell/capture/motion.hpp"
#include "mbncc/cell/scene_difference.hpp"

namespace mbncc {
namespace {

constexpr std::size_t kPeriodsKept = 8;

}  // namespace

SceneWatch::SceneWatch(double still_time) : still_time_(still_time) {
  if (!(still_time > 0)) throw std::invalid_argument("still_time must be above 0");
}

void SceneWatch::update(double stamp, const cv::Mat& image) {
  if (image.empty() || image.type() != CV_8UC3)
    throw std::invalid_argument("the scene watch needs non-empty CV_8UC3 images");
  if (stamp < last_stamp_ || image.size() != size_) reset();
  last_stamp_ = stamp;
  size_ = image.size();
  const cv::Mat small = capture::motion_image(image);
  if (anchor_.empty() || capture::has_moved(anchor_, small)) {
    end_period();
    begin_candidate(stamp, small);
  } else if (still_ || stamp - anchor_stamp_ >= still_time_) {
    keep_shot(stamp, image);
  }
}

void SceneWatch::reset() {
  anchor_.release();
  still_ = false;
  waiting_ = settled_ = {};
  past_.clear();
  last_stamp_ = 0;
}

void SceneWatch::begin_candidate(double stamp, const cv::Mat& small) {
  anchor_ = small;
  anchor_stamp_ = stamp;
}

void SceneWatch::keep_shot(double stamp, const cv::Mat& image) {
  if (!still_) {
    still_ = true;
    waiting_ = settled_ = {image, stamp, ++periods_};
    return;
  }
  // The newest images may show the beginning of a motion that is not detected yet.
  if (stamp - waiting_.stamp >= still_time_ / 2) {
    settled_ = waiting_;
    waiting_ = {image, stamp, periods_};
  }
}

void SceneWatch::end_period() {
  if (!still_) return;
  still_ = false;
  past_.push_back(settled_);
  if (past_.size() > kPeriodsKept) past_.pop_front();
}

std::optional<StillShot> SceneWatch::still() const {
  if (!still_) return std::nullopt;
  return settled_;
}

std::optional<StillShot> SceneWatch::before_change() const {
  if (!still_) return std::nullopt;
  const auto found = std::find_if(past_.rbegin(), past_.rend(), [this](const StillShot& shot) {
    return scene_change(shot.image, settled_.image) == SceneChange::kInside;
  });
  if (found == past_.rend()) return std::nullopt;
  return *found;
}

}  // namespace mbncc
