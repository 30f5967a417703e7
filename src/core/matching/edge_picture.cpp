#include "matching/edge_picture.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "polar/kernels.hpp"

namespace mbncc {

cv::Mat strongest_gradient(const cv::Mat& picture) {
  cv::Mat along_x, along_y;
  cv::Sobel(picture, along_x, CV_16S, 1, 0);
  cv::Sobel(picture, along_y, CV_16S, 0, 1);
  cv::Mat gradient(picture.size(), CV_16SC2);
  for (int y = 0; y < picture.rows; ++y)
    kernels::strongest_of_three(along_x.ptr<std::int16_t>(y), along_y.ptr<std::int16_t>(y),
                                gradient.ptr<std::int16_t>(y), picture.cols);
  return gradient;
}

cv::Mat edge_picture(const cv::Mat& gradient) {
  cv::Mat edges(gradient.size(), CV_8SC2);
  for (int y = 0; y < gradient.rows; ++y)
    kernels::edge_vectors(gradient.ptr<std::int16_t>(y), edges.ptr<std::int8_t>(y), gradient.cols);
  return edges;
}

}  // namespace mbncc
