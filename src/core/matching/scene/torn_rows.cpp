// SPDX-License-Identifier: BSD-3-Clause
#include "matching/scene/torn_rows.hpp"

#include <algorithm>
#include <limits>
#include <vector>

namespace mbncc::scene {
namespace {

constexpr int kSmallest = 3;          // [px] least displacement; texture explains smaller ones
constexpr int kLargest = 14;          // [px] largest displacement
constexpr double kPeak = 2;           // least ratio of a peak to the differences beside it
constexpr double kUnexplained = 0.6;  // largest part of a peak left by a displacement

/// [grey^2] Mean square difference between `columns` of a row and those of the row below, shifted
/// by `way` [px], plus that of rounding.
double difference(const cv::Mat& grey, int row, cv::Range columns, int way) {
  constexpr double kRounding = 1;
  const int from = std::max(columns.start, -way), to = std::min(columns.end, grey.cols - way);
  const uchar* upper = grey.ptr(row);
  const uchar* lower = grey.ptr(row + 1) + way;
  int squares = 0;
  for (int x = from; x < to; ++x) squares += (lower[x] - upper[x]) * (lower[x] - upper[x]);
  return kRounding + static_cast<double>(squares) / std::max(1, to - from);
}

double least_displaced(const cv::Mat& grey, int row, cv::Range columns) {
  double least = std::numeric_limits<double>::infinity();
  for (int way = kSmallest; way <= kLargest; ++way)
    for (const int signed_way : {-way, way})
      least = std::min(least, difference(grey, row, columns, signed_way));
  return least;
}

}  // namespace

bool has_torn_rows(const cv::Mat& grey, const cv::Rect& box) {
  // Tears near the ends of an object hardly displace its pose. A tear also displaces the
  // surroundings, so they are compared as well.
  const int outer = box.height / 5;
  const cv::Rect around =
      cv::Rect(box.x - box.width, box.y + outer - 1, 3 * box.width, box.height - 2 * outer + 3) &
      cv::Rect({}, grey.size());
  if (around.width <= 2 * kLargest) return false;
  const cv::Range columns(around.x, around.x + around.width);
  std::vector<double> differences;
  for (int row = around.y; row + 1 < around.y + around.height; ++row)
    differences.push_back(difference(grey, row, columns, 0));
  int displaced = 0;
  for (std::size_t i = 1; i + 1 < differences.size(); ++i) {
    const double peak = differences[i];
    if (!(peak > kPeak * std::max(differences[i - 1], differences[i + 1]))) continue;
    if (least_displaced(grey, around.y + static_cast<int>(i), columns) < kUnexplained * peak)
      ++displaced;
  }
  return displaced == 1;  // several rows: the platform is chequered or made of bricks
}

}  // namespace mbncc::scene
