// SPDX-License-Identifier: BSD-3-Clause
// Whether the images that arrive are live: a frozen camera repeats one, a recording has old
// stamps.
#pragma once

#include <sensor_msgs/Image.h>

#include <string>

namespace mbncc::console {

class ImageOrigin {
 public:
  /// Images that are stamped this long ago are recorded. [s]
  static constexpr double kOld = 10;
  /// So many equal images in a row, for so long [s], are one image.
  static constexpr int kEqual = 5;
  static constexpr double kStill = 2;

  /// The next image, which arrives at `now`.
  void take(const sensor_msgs::ImageConstPtr& image, ros::Time now);

  /// "": the images are live.
  std::string warning() const;

 private:
  sensor_msgs::ImageConstPtr last_;
  int equal_ = 0;  // images in a row, before the last one
  ros::Time since_, now_;
};

}  // namespace mbncc::console
