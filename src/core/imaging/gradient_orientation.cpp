// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/gradient_orientation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "simd/kernels.hpp"

namespace mbncc::imaging {
namespace {

constexpr int kChannels = 3;
constexpr int kReach = 2;  // [px] reach of the smoothing

/// Weights in 256ths of the pixel itself and of those one and two pixels away.
std::array<int, kReach + 1> gaussian(double sigma) {
  const double one = std::exp(-0.5 / (sigma * sigma)), two = std::exp(-2 / (sigma * sigma));
  const double scale = 256 / (1 + 2 * one + 2 * two);
  const int near = static_cast<int>(std::lround(scale * one));
  const int far = static_cast<int>(std::lround(scale * two));
  return {256 - 2 * near - 2 * far, near, far};
}

/// One region of an image; rows are computed from top to bottom.
class Region {
 public:
  Region(const cv::Mat& image, const cv::Rect& region, double sigma)
      : image_(image),
        region_(region),
        weights_(gaussian(sigma)),
        width_((region.width + 2) * kChannels),
        columns_(width_ + 2 * kReach * kChannels),
        smooth_(static_cast<std::size_t>(width_) * (region.height + 2)) {}

  void smooth() {
    for (int y = -1; y <= region_.height; ++y) smooth_row(y);
  }

  /// Row of `region_` from its first pixel on; there is one more pixel on each side.
  const std::uint8_t* row(int y) const {
    return &smooth_[static_cast<std::size_t>(width_) * (y + 1) + kChannels];
  }

  void find_edges(int y, std::int8_t* edges) {
    const auto values = static_cast<std::size_t>(region_.width) * kChannels;
    along_x_.resize(values);
    along_y_.resize(values);
    gradient_.resize(2 * values);
    const std::uint8_t* rows[] = {row(y - 1), row(y), row(y + 1)};
    kernels::slopes(rows, along_x_.data(), along_y_.data(), static_cast<int>(values));
    kernels::strongest_of_three(along_x_.data(), along_y_.data(), gradient_.data(), region_.width);
    kernels::edge_vectors(gradient_.data(), row(y), edges, region_.width);
  }

 private:
  void smooth_row(int y) {
    const std::uint8_t* rows[2 * kReach + 1];
    for (int k = -kReach; k <= kReach; ++k) rows[k + kReach] = source_row(y + k, k + kReach);
    kernels::smooth_columns(rows, weights_.data(), columns_.data(),
                            static_cast<int>(columns_.size()));
    kernels::smooth_along_row(columns_.data() + kReach * kChannels, weights_.data(),
                              smooth_.data() + static_cast<std::size_t>(width_) * (y + 1), width_);
  }

  /// A row of the image, starting kReach + 1 pixels left of the region.
  const std::uint8_t* source_row(int y, int slot) {
    const int row = std::clamp(region_.y + y, 0, image_.rows - 1);
    const int first = region_.x - 1 - kReach, pixels = region_.width + 2 + 2 * kReach;
    const std::uint8_t* from = image_.ptr(row);
    if (first >= 0 && first + pixels <= image_.cols) return from + kChannels * first;
    auto& continued = continued_[slot];
    continued.resize(static_cast<std::size_t>(pixels) * kChannels);
    const int left = std::max(0, -first), right = std::max(0, first + pixels - image_.cols);
    const auto copy = [&](int to, int column, int count) {
      std::memcpy(&continued[static_cast<std::size_t>(kChannels) * to], from + kChannels * column,
                  static_cast<std::size_t>(kChannels) * count);
    };
    for (int x = 0; x < left; ++x) copy(x, 0, 1);
    copy(left, first + left, pixels - left - right);
    for (int x = pixels - right; x < pixels; ++x) copy(x, image_.cols - 1, 1);
    return continued.data();
  }

  const cv::Mat& image_;
  cv::Rect region_;
  std::array<int, kReach + 1> weights_;
  int width_;  // number of values in a row of smooth_
  std::vector<std::uint16_t> columns_;
  std::vector<std::uint8_t> smooth_;
  std::array<std::vector<std::uint8_t>, 2 * kReach + 1> continued_;
  std::vector<std::int16_t> along_x_, along_y_, gradient_;
};

}  // namespace

cv::Mat strongest_gradient(const cv::Mat& image) {
  cv::Mat along_x, along_y;
  cv::Sobel(image, along_x, CV_16S, 1, 0);
  cv::Sobel(image, along_y, CV_16S, 0, 1);
  cv::Mat gradient(image.size(), CV_16SC2);
  for (int y = 0; y < image.rows; ++y)
    kernels::strongest_of_three(along_x.ptr<std::int16_t>(y), along_y.ptr<std::int16_t>(y),
                                gradient.ptr<std::int16_t>(y), image.cols);
  return gradient;
}

void smooth_and_find_edges(const cv::Mat& image, const cv::Rect& region, double sigma,
                           cv::Mat& smooth, cv::Mat& edges) {
  Region work(image, region, sigma);
  work.smooth();
  for (int y = 0; y < region.height; ++y) {
    std::memcpy(smooth.ptr(region.y + y) + kChannels * region.x, work.row(y),
                static_cast<std::size_t>(region.width) * kChannels);
    work.find_edges(y, edges.ptr<std::int8_t>(region.y + y) + 2 * region.x);
  }
}

}  // namespace mbncc::imaging
