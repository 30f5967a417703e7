#include "matching/scene_picture.hpp"

#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "mbncc/matching/pyramid.hpp"

namespace mbncc {
namespace {

cv::Mat to_grey(const cv::Mat& picture) {
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

}  // namespace

ScenePicture::ScenePicture(const cv::Mat& picture, int top_level)
    : grey(build_pyramid(to_grey(picture), top_level)) {}

}  // namespace mbncc
