// SPDX-License-Identifier: BSD-3-Clause
// Lets service calls wait for the next live image.
#pragma once

#include <ros/time.h>
#include <sensor_msgs/Image.h>

#include <condition_variable>
#include <functional>
#include <mutex>

namespace mbncc::nodelets {

class ImageWait {
 public:
  /// Camera side: call this with every image. It is stored only while a call waits.
  void offer(const sensor_msgs::ImageConstPtr& image);

  /// Service side: images are wanted from enter() to leave().
  void enter();
  void leave();
  bool wanted() const;

  /// The next image stamped later than `after`; null if none arrives within `timeout` [s] by the
  /// steady clock, or after close().
  sensor_msgs::ImageConstPtr next(const ros::Time& after, double timeout);

  /// Makes current and later calls of next() return null.
  void close();

 private:
  mutable std::mutex mutex_;
  std::condition_variable offered_;
  sensor_msgs::ImageConstPtr newest_;
  int waiting_ = 0;
  bool closed_ = false;
};

/// Images are wanted during its lifetime.
class Listening {
 public:
  /// `wants_changed` is called when live images become needed or unneeded. Both must outlive it.
  Listening(ImageWait& images, const std::function<void()>& wants_changed)
      : images_(images), wants_changed_(wants_changed) {
    images_.enter();
    wants_changed_();
  }
  ~Listening() {
    images_.leave();
    wants_changed_();
  }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;

 private:
  ImageWait& images_;
  const std::function<void()>& wants_changed_;
};

}  // namespace mbncc::nodelets
