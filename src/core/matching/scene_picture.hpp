// What is computed once per picture and shared by all objects.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc {

struct ScenePicture {
  /// `picture` is CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; else std::invalid_argument.
  ScenePicture(const cv::Mat& picture, int top_level);

  int top_level() const { return static_cast<int>(grey.size()) - 1; }
  cv::Size size() const { return grey.front().size(); }

  std::vector<cv::Mat> grey;  ///< CV_8UC1 pyramid
};

}  // namespace mbncc
