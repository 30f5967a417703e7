#include "learning/line_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace mbncc {
namespace {

constexpr int kDirections = 8;
constexpr int kReach = 6;  // [px] of a line to either side of its middle
constexpr int kLength = 2 * kReach + 1;
constexpr int kBeside = 5;  // [px] so far beside a thin line there is platform
constexpr float kMost = 3;  // any pixel's say
constexpr int kFrame = kReach + kBeside;

cv::Point rounded(double length, double angle) {
  return {static_cast<int>(std::lround(length * std::cos(angle))),
          static_cast<int>(std::lround(length * std::sin(angle)))};
}

using Lines = std::array<const float*, kLength>;

// Spelled out, so that several pixels are worked on at a time.
template <std::size_t... kPixel>
void add_up(const Lines& lines, int begin, int end, float* mean, std::index_sequence<kPixel...>) {
  for (int x = begin; x < end; ++x) mean[x] = (0.F + ... + lines[kPixel][x]) / kLength;
}

// Means along lines of one direction; as far from the frame as lines reach.
void line_means(const cv::Mat& framed, double angle, cv::Mat& means) {
  for (int y = kReach; y < framed.rows - kReach; ++y) {
    Lines lines{};
    for (int i = -kReach; i <= kReach; ++i) {
      const cv::Point step = rounded(i, angle);
      lines[i + kReach] = framed.ptr<float>(y + step.y) + step.x;
    }
    add_up(lines, kReach, framed.cols - kReach, means.ptr<float>(y),
           std::make_index_sequence<kLength>());
  }
}

// Raises `best` to the means of lines with platform on both sides.
void take_thin_lines(const cv::Mat& means, double angle, cv::Mat& best) {
  const cv::Point across = rounded(kBeside, angle + CV_PI / 2);
  for (int y = 0; y < best.rows; ++y) {
    const auto* here = means.ptr<float>(y + kFrame) + kFrame;
    const auto* left = means.ptr<float>(y + kFrame - across.y) + kFrame - across.x;
    const auto* right = means.ptr<float>(y + kFrame + across.y) + kFrame + across.x;
    auto* out = best.ptr<float>(y);
    for (int x = 0; x < best.cols; ++x)
      if (left[x] <= 0 && right[x] <= 0) out[x] = std::max(out[x], here[x]);
  }
}

}  // namespace

cv::Mat line_evidence(const cv::Mat& preference) {
  cv::Mat framed, best(preference.size(), CV_32FC1, cv::Scalar(-kMost));
  const cv::Mat clipped = cv::max(cv::min(preference, kMost), -kMost);
  cv::copyMakeBorder(clipped, framed, kFrame, kFrame, kFrame, kFrame, cv::BORDER_CONSTANT,
                     cv::Scalar(-kMost));
  cv::Mat means(framed.size(), CV_32FC1, cv::Scalar(-kMost));
  for (int i = 0; i < kDirections; ++i) {
    const double angle = i * CV_PI / kDirections;
    line_means(framed, angle, means);
    take_thin_lines(means, angle, best);
  }
  return best;
}

}  // namespace mbncc
