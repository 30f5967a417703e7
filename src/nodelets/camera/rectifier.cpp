// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/rectifier.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

namespace mbncc::nodelets {
namespace {

bool is_same(const Lens& a, const Lens& b) {
  return matrix_of(a.camera) == matrix_of(b.camera) && a.distortion == b.distortion &&
         a.is_fisheye == b.is_fisheye;
}

bool is_same(const TurnedCamera& a, const TurnedCamera& b) {
  return a.rotation == b.rotation && matrix_of(a.camera) == matrix_of(b.camera);
}

}  // namespace

cv::Mat Rectifier::rectify(const cv::Mat& image, const Lens& lens, const TurnedCamera& wanted) {
  if (places_.size() != image.size() || !is_same(lens, lens_) || !is_same(wanted, wanted_))
    prepare(lens, wanted, image.size());
  cv::Mat rectified;
  cv::remap(image, rectified, places_, fractions_, cv::INTER_LINEAR);
  return rectified;
}

void Rectifier::prepare(const Lens& lens, const TurnedCamera& wanted, cv::Size size) {
  lens_ = lens;
  wanted_ = wanted;
  const cv::Matx33d raw = matrix_of(lens.camera), straight = matrix_of(wanted.camera);
  if (lens.is_fisheye)
    cv::fisheye::initUndistortRectifyMap(raw, lens.distortion, wanted.rotation, straight, size,
                                         CV_16SC2, places_, fractions_);
  else
    cv::initUndistortRectifyMap(raw, lens.distortion, wanted.rotation, straight, size, CV_16SC2,
                                places_, fractions_);
}

}  // namespace mbncc::nodelets
