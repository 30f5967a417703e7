// What is computed once per picture and shared by all objects.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

#include "matching/colour_classes.hpp"
#include "matching/scene_level.hpp"

namespace mbncc {

/// `picture` as grey: CV_8UC3 (bgr) or CV_8UC1, at least 16 x 16; else std::invalid_argument.
cv::Mat grey_picture(const cv::Mat& picture);

struct ScenePicture {
  /// `picture` as for grey_picture(). `with_classes`: what the colour gates need, too.
  ScenePicture(const cv::Mat& picture, int top_level, bool with_classes = false);

  int top_level() const { return static_cast<int>(grey.size()) - 1; }
  cv::Size size() const { return grey.front().size(); }

  std::vector<cv::Mat> grey;       ///< CV_8UC1 pyramid
  std::vector<SceneLevel> levels;  ///< as many
  std::optional<ClassPictures> classes;
};

}  // namespace mbncc
