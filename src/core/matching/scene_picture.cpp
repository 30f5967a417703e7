#include "matching/scene_picture.hpp"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

cv::Mat to_colour(const cv::Mat& picture) {
  if (picture.type() == CV_8UC3) return picture;
  cv::Mat colour;
  cv::cvtColor(picture, colour, cv::COLOR_GRAY2BGR);
  return colour;
}

}  // namespace

cv::Mat grey_picture(const cv::Mat& picture) {
  constexpr int kSmallest = 16;
  if (picture.type() != CV_8UC3 && picture.type() != CV_8UC1)
    throw std::invalid_argument("a picture to search must be 8-bit colour or grey");
  if (picture.cols < kSmallest || picture.rows < kSmallest)
    throw std::invalid_argument("a picture to search must have at least 16 x 16 pixels");
  if (picture.type() == CV_8UC1) return picture;
  cv::Mat grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

ScenePicture::ScenePicture(const cv::Mat& picture, int top_level, bool with_classes) {
  grey = build_pyramid(grey_picture(picture), top_level);
  const auto colours = build_pyramid(to_colour(picture), top_level);
  for (std::size_t level = 0; level < colours.size(); ++level)
    levels.emplace_back(colours[level], static_cast<int>(level));
  if (with_classes) classes.emplace(colours);
}

}  // namespace mbncc
