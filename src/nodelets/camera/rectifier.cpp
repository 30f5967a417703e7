// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/rectifier.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {
namespace {

/// R may rotate the images, as rectification does.
std::string fault_of(sensor_msgs::CameraInfo info, cv::Size size) {
  const std::string fault = fault_of_calibration(info, true, size);
  if (!fault.empty()) return fault;
  info.R.fill(0);
  return fault_of_calibration(info, false, size);
}

}  // namespace

Rectified Rectifier::rectify(const cv::Mat& image, const sensor_msgs::CameraInfo& info) {
  Rectified rectified{{}, fault_of(info, image.size())};
  if (!rectified) return rectified;
  take_over(info, image.size());
  cv::remap(image, rectified.image, places_, fractions_, cv::INTER_LINEAR);
  return rectified;
}

void Rectifier::take_over(const sensor_msgs::CameraInfo& info, cv::Size size) {
  sensor_msgs::CameraInfo nameless = info;
  nameless.header = {};
  if (!places_.empty() && nameless == info_) return;
  info_ = nameless;
  const Lens lens = lens_of(info);
  const cv::Matx33d raw = matrix_of(lens.camera), straight = matrix_of(rectified_camera_of(info));
  const cv::Matx33d turn = rectification_of(info);
  if (lens.is_fisheye)
    cv::fisheye::initUndistortRectifyMap(raw, lens.distortion, turn, straight, size, CV_16SC2,
                                         places_, fractions_);
  else
    cv::initUndistortRectifyMap(raw, lens.distortion, turn, straight, size, CV_16SC2, places_,
                                fractions_);
}

}  // namespace mbncc::nodelets
