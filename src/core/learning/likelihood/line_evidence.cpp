// SPDX-License-Identifier: BSD-3-Clause
#include "learning/likelihood/line_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core/hal/intrin.hpp>

namespace mbncc::likelihood {
namespace {

constexpr int kDirections = 8;
constexpr int kReach = 6;  // [px] reach of a line to either side of its middle
constexpr int kLength = 2 * kReach + 1;
constexpr int kBeside = 5;  // [px] distance beside a line at which its sides are checked
constexpr float kMost = 3;  // largest log-odds of a pixel
constexpr int kFrame = kReach + kBeside;
constexpr int kLanes = cv::v_float32x4::nlanes;

cv::Point rounded(double length, double angle) {
  return {static_cast<int>(std::lround(length * std::cos(angle))),
          static_cast<int>(std::lround(length * std::sin(angle)))};
}

using Lines = std::array<const float*, kLength>;

// Means of the pixels `begin` .. `end`, at least kLanes; the last group overlaps the one before
// it.
void average(const Lines& lines, int begin, int end, float* means) {
  for (int x = begin; x < end; x += kLanes) {
    const int first = std::min(x, end - kLanes);
    cv::v_float32x4 sum = cv::v_setzero_f32();
    for (const float* line : lines) sum += cv::v_load(line + first);
    cv::v_store(means + first, sum / cv::v_setall_f32(kLength));
  }
}

// Means along lines of one direction, for the pixels whose line lies inside `framed`.
void line_means(const cv::Mat& framed, double angle, cv::Mat& means) {
  std::array<cv::Point, kLength> steps;
  for (int i = 0; i < kLength; ++i) steps[i] = rounded(i - kReach, angle);
  for (int y = kReach; y < framed.rows - kReach; ++y) {
    Lines lines{};
    for (int i = 0; i < kLength; ++i) lines[i] = framed.ptr<float>(y + steps[i].y) + steps[i].x;
    average(lines, kReach, framed.cols - kReach, means.ptr<float>(y));
  }
}

// Raises the evidence to the means of lines, where both sides of a line are platform (parts) or
// object (gaps).
void update_evidence(const cv::Mat& means, double angle, LineEvidence& best) {
  const cv::Point across = rounded(kBeside, angle + CV_PI / 2);
  const cv::v_float32x4 none = cv::v_setzero_f32();
  for (int y = 0; y < best.parts.rows; ++y) {
    const auto* here = means.ptr<float>(y + kFrame) + kFrame;
    const auto* left = means.ptr<float>(y + kFrame - across.y) + kFrame - across.x;
    const auto* right = means.ptr<float>(y + kFrame + across.y) + kFrame + across.x;
    auto* part = best.parts.ptr<float>(y);
    auto* gap = best.gaps.ptr<float>(y);
    for (int x = 0; x < best.parts.cols; x += kLanes) {
      const int first = std::min(x, best.parts.cols - kLanes);
      const auto mean = cv::v_load(here + first);
      const auto one = cv::v_load(left + first), other = cv::v_load(right + first);
      const auto parts = cv::v_load(part + first), gaps = cv::v_load(gap + first);
      cv::v_store(part + first,
                  cv::v_select(cv::v_max(one, other) <= none, cv::v_max(parts, mean), parts));
      cv::v_store(gap + first,
                  cv::v_select(cv::v_min(one, other) >= none, cv::v_max(gaps, none - mean), gaps));
    }
  }
}

}  // namespace

LineEvidence line_evidence(const cv::Mat& preference) {
  cv::Mat framed;
  // Narrower images are processed as kLanes wide, for which the frame has room.
  const cv::Size worked(std::max(preference.cols, kLanes), preference.rows);
  LineEvidence best{cv::Mat(worked, CV_32FC1, cv::Scalar(-kMost)),
                    cv::Mat(worked, CV_32FC1, cv::Scalar(-kMost))};
  const cv::Mat clipped = cv::max(cv::min(preference, kMost), -kMost);
  cv::copyMakeBorder(clipped, framed, kFrame, kFrame, kFrame, kFrame, cv::BORDER_CONSTANT,
                     cv::Scalar(-kMost));
  cv::Mat means(framed.size(), CV_32FC1, cv::Scalar(-kMost));
  for (int i = 0; i < kDirections; ++i) {
    const double angle = i * CV_PI / kDirections;
    line_means(framed, angle, means);
    update_evidence(means, angle, best);
  }
  return {best.parts.colRange(0, preference.cols), best.gaps.colRange(0, preference.cols)};
}

}  // namespace mbncc::likelihood
