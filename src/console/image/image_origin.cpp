// SPDX-License-Identifier: BSD-3-Clause
#include "console/image/image_origin.hpp"

#include <cmath>
#include <ctime>

namespace mbncc::console {
namespace {

std::string date_of(const ros::Time& stamp) {
  const auto time = static_cast<std::time_t>(stamp.sec);
  std::tm parts{};
  ::localtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts);
  return text;
}

}  // namespace

void ImageOrigin::take(const sensor_msgs::ImageConstPtr& image, ros::Time now) {
  // Comparing is cheap: the noise makes live images differ within the first bytes.
  const bool equal = last_ && image->data == last_->data;
  equal_ = equal ? equal_ + 1 : 0;
  if (!equal) since_ = now;
  last_ = image;
  now_ = now;
}

std::string ImageOrigin::warning() const {
  if (!last_) return "";
  const ros::Time& stamp = last_->header.stamp;
  if (!stamp.isZero() && (now_ - stamp).toSec() > kOld) return "RECORDED " + date_of(stamp);
  const double still = (now_ - since_).toSec();
  if (equal_ < kEqual || still < kStill) return "";
  return "THE SAME IMAGE for " + std::to_string(std::lround(still)) +
         " s: camera frozen, or a recording";
}

}  // namespace mbncc::console
