// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/map_level.hpp"

#include <algorithm>
#include <stdexcept>

#include "imaging/pyramid.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::templates {
namespace {

// Padding for whole squares at the right and bottom edge, because the pyramid drops odd rows and
// columns.
cv::Mat padded_to_squares(const cv::Mat& image, int side) {
  const int right = (side - image.cols % side) % side;
  const int below = (side - image.rows % side) % side;
  cv::Mat padded;
  cv::copyMakeBorder(image, padded, 0, std::max(below, 4 * side - image.rows), 0,
                     std::max(right, 4 * side - image.cols), cv::BORDER_CONSTANT, cv::Scalar(0));
  return padded;
}

}  // namespace

MapLevel map_level(const cv::Mat& grey, const cv::Mat& map, int level) {
  if (grey.type() != CV_8UC1 || !is_binary_map(map) || grey.size() != map.size())
    throw std::invalid_argument("a template needs a grey image and a binary map of its size");
  cv::Mat weight, weighted;
  map.convertTo(weight, CV_32F, 1.0 / 255);
  grey.convertTo(weighted, CV_32F);
  weighted = weighted.mul(weight);
  const int side = 1 << level;
  MapLevel result;
  result.coverage = imaging::build_pyramid(padded_to_squares(weight, side), level).back();
  result.values = imaging::build_pyramid(padded_to_squares(weighted, side), level).back();
  result.values /= cv::max(result.coverage, 1e-6);
  return result;
}

}  // namespace mbncc::templates
