// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/part_put_down.hpp"

#include <array>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace mbncc {
namespace {

constexpr int kGap = 7, kRing = 31;  // [px] sides of the dilations that bound the ring
constexpr int kBits = 5;             // shift from grey levels to bins: 8 bins a channel
constexpr double kRare = 0.005;  // part of the ring that every colour is assumed to cover at least
constexpr double kClearRatio = 4;  // likelihood ratio from which a pixel counts

std::size_t bin_of(const cv::Vec3b& colour) {
  return static_cast<std::size_t>((colour[0] >> kBits) << 6 | (colour[1] >> kBits) << 3 |
                                  colour[2] >> kBits);
}

/// Colour histogram of the platform around a map, in both images.
class PlatformColours {
 public:
  PlatformColours(const cv::Mat& ring, const cv::Mat& before, const cv::Mat& after) {
    // With this offset, a rare colour counts like one that does not occur.
    counts_.fill(kRare * 2 * cv::countNonZero(ring) + 1);
    for (int y = 0; y < ring.rows; ++y)
      for (int x = 0; x < ring.cols; ++x)
        if (ring.at<uchar>(y, x) != 0) {
          ++counts_[bin_of(before.at<cv::Vec3b>(y, x))];
          ++counts_[bin_of(after.at<cv::Vec3b>(y, x))];
        }
  }

  double count(const cv::Vec3b& colour) const { return counts_[bin_of(colour)]; }

 private:
  std::array<double, 512> counts_;
};

cv::Mat dilated(const cv::Mat& map, int side) {
  cv::Mat result;
  cv::dilate(map, result, cv::getStructuringElement(cv::MORPH_ELLIPSE, {side, side}));
  return result;
}

}  // namespace

double part_put_down(const cv::Mat& map, const cv::Mat& before, const cv::Mat& after) {
  if (map.type() != CV_8UC1 || before.type() != CV_8UC3 || after.type() != CV_8UC3 ||
      map.size() != before.size() || map.size() != after.size())
    throw std::invalid_argument("map and images must be of one size, CV_8UC1 and CV_8UC3");
  cv::Mat calm_before, calm_after;
  cv::blur(before, calm_before, {5, 5});
  cv::blur(after, calm_after, {5, 5});
  const PlatformColours platform(dilated(map, kRing) - dilated(map, kGap), calm_before, calm_after);
  int came = 0, left = 0;
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) {
      if (map.at<uchar>(y, x) == 0) continue;
      const double ratio = platform.count(calm_after.at<cv::Vec3b>(y, x)) /
                           platform.count(calm_before.at<cv::Vec3b>(y, x));
      came += ratio < 1 / kClearRatio ? 1 : 0;
      left += ratio > kClearRatio ? 1 : 0;
    }
  return came == 0 ? 0 : static_cast<double>(came) / (came + left);
}

}  // namespace mbncc
