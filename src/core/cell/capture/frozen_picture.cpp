// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/frozen_picture.hpp"

#include <cstring>

namespace mbncc {
namespace {

constexpr int kFrozenFrom = 5;  // equal pictures in a row

bool equal(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  const std::size_t row_length = a.cols * a.elemSize();
  for (int row = 0; row < a.rows; ++row)
    if (std::memcmp(a.ptr(row), b.ptr(row), row_length) != 0) return false;
  return true;
}

}  // namespace

bool FrozenPicture::update(const cv::Mat& picture) {
  equal_ = !last_.empty() && equal(last_, picture) ? equal_ + 1 : 1;
  last_ = picture;
  return equal_ >= kFrozenFrom;
}

void FrozenPicture::reset() {
  last_.release();
  equal_ = 0;
}

}  // namespace mbncc
