// What is computed once per picture and shared by all objects.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc {

/// `picture` as grey: CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; else std::invalid_argument.
cv::Mat grey_picture(const cv::Mat& picture);

/// A picture at one pyramid level, as evidence is read from it.
struct SceneLevel {
  /// `colour` is CV_8UC3; it is smoothed a little against noise, more at level 0.
  SceneLevel(const cv::Mat& colour, int level);

  cv::Size size() const { return colour.size(); }

  cv::Mat colour;    ///< CV_8UC3, smoothed
  cv::Mat gradient;  ///< CV_16SC2, see strongest_gradient()
  cv::Mat edges;     ///< CV_8SC2, see edge_picture()
};

struct ScenePicture {
  /// `picture` as for grey_picture().
  ScenePicture(const cv::Mat& picture, int top_level);

  int top_level() const { return static_cast<int>(grey.size()) - 1; }
  cv::Size size() const { return grey.front().size(); }

  std::vector<cv::Mat> grey;       ///< CV_8UC1 pyramid
  std::vector<SceneLevel> levels;  ///< as many
};

}  // namespace mbncc
