// SPDX-License-Identifier: BSD-3-Clause
// Detects images that are not live: a frozen camera repeats one image, a recording has old stamps.
#pragma once

#include <sensor_msgs/Image.h>

#include <string>

namespace mbncc::console {

class ImageOrigin {
 public:
  /// Images whose stamp is older than this are recorded. [s]
  static constexpr double kOld = 10;
  /// Images count as frozen after this many equal ones in a row for this long [s].
  static constexpr int kEqual = 5;
  static constexpr double kStill = 2;

  /// Takes the next image, which arrived at `now`.
  void take(const sensor_msgs::ImageConstPtr& image, ros::Time now);

  /// Why the images are not live; "" if they are.
  std::string warning() const;

 private:
  sensor_msgs::ImageConstPtr last_;
  int equal_ = 0;  // number of preceding images that equal the last one
  ros::Time since_, now_;
};

}  // namespace mbncc::console
