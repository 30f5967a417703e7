// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/frozen_image.hpp"

#include <cstring>

namespace mbncc {
namespace {

constexpr int kFrozenFrom = 5;  // equal images in a row

bool equal(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  const std::size_t row_length = a.cols * a.elemSize();
  for (int row = 0; row < a.rows; ++row)
    if (std::memcmp(a.ptr(row), b.ptr(row), row_length) != 0) return false;
  return true;
}

}  // namespace

bool FrozenImage::update(const cv::Mat& image) {
  equal_ = !last_.empty() && equal(last_, image) ? equal_ + 1 : 1;
  last_ = image;
  return equal_ >= kFrozenFrom;
}

}  // namespace mbncc
