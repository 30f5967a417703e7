// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/grey_image.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc::scene {

cv::Mat grey_image(const cv::Mat& image) {
  check_searchable(image);
  if (image.type() == CV_8UC1) return image;
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

bool is_grey(const cv::Mat& image) {
  check_type(image);
  if (image.type() == CV_8UC1) return true;
  for (int y = 0; y < image.rows; ++y) {
    const auto* row = image.ptr<cv::Vec3b>(y);
    if (std::any_of(row, row + image.cols,
                    [](const cv::Vec3b& p) { return p[0] != p[1] || p[1] != p[2]; }))
      return false;
  }
  return true;
}

}  // namespace mbncc::scene
