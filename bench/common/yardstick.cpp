// SPDX-License-Identifier: BSD-3-Clause
#include "common/yardstick.hpp"

#include <opencv2/imgproc.hpp>

namespace mbncc::bench {
namespace {

cv::Mat noise(cv::Size size, int type) {
  cv::Mat image(size, type);
  cv::RNG generator(1);
  generator.fill(image, cv::RNG::UNIFORM, 0, 255);
  return image;
}

}  // namespace

MatchYardstick::MatchYardstick()
    : image_(noise({640, 480}, CV_8UC1)), template_(image_({100, 100, 101, 101}).clone()) {}

void MatchYardstick::run() {
  cv::matchTemplate(image_, template_, scores_, cv::TM_CCOEFF_NORMED);
}

CutYardstick::CutYardstick() {
  cv::GaussianBlur(noise({200, 200}, CV_8UC3), image_, {}, 3);
}

void CutYardstick::run() {
  labels_ = cv::Mat::zeros(image_.size(), CV_8UC1);
  background_ = cv::Mat::zeros(1, 65, CV_64F);
  foreground_ = cv::Mat::zeros(1, 65, CV_64F);
  cv::grabCut(image_, labels_, {40, 40, 120, 120}, background_, foreground_, 2,
              cv::GC_INIT_WITH_RECT);
}

}  // namespace mbncc::bench
