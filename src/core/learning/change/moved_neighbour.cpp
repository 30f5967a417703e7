// SPDX-License-Identifier: BSD-3-Clause
#include "learning/change/moved_neighbour.hpp"

#include <algorithm>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/half_size.hpp"

namespace mbncc::change {
namespace {

// All lengths are in pixels of the images at half resolution.
constexpr int kReach = 8;              // largest displacement of a neighbour
constexpr int kPatch = 3;              // half the side of the squares that are compared
constexpr int kStride = 2;             // distance between the squares
constexpr int kNeighbourDistance = 7;  // distance within which squares must have moved alike
// Least number of squares within kNeighbourDistance that moved alike
constexpr int kFewestAlike = 6;
// Least part of the squares within kNeighbourDistance that moved alike
constexpr double kPartAlike = 0.4;
constexpr float kNoiseFactor = 3;     // mean square explained by noise, in variances
constexpr float kLeftPart = 0.3F;     // part of a square's contrast that may stay unexplained
constexpr float kLeastContrast = 40;  // [grey levels^2] least contrast of a recognisable square

struct Motion {
  cv::Point at, by;
};

// Sum of squared differences between two squares; stops beyond `limit`.
float mismatch(const cv::Mat& before, const cv::Point& p, const cv::Mat& after, const cv::Point& q,
               float limit) {
  float sum = 0;
  for (int dy = -kPatch; dy <= kPatch && sum < limit; ++dy) {
    const float* a = before.ptr<float>(p.y + dy) + 3 * (p.x - kPatch);
    const float* b = after.ptr<float>(q.y + dy) + 3 * (q.x - kPatch);
    for (int i = 0; i < 3 * (2 * kPatch + 1); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return sum;
}

// Sum of squared deviations from the square's mean colour.
float contrast_of(const cv::Mat& image, const cv::Point& p) {
  const cv::Mat square =
      image(cv::Rect(p.x - kPatch, p.y - kPatch, 2 * kPatch + 1, 2 * kPatch + 1));
  cv::Scalar mean, deviation;
  cv::meanStdDev(square, mean, deviation);
  return static_cast<float>(deviation.dot(deviation) * static_cast<double>(square.total()));
}

class NeighbourSearch {
 public:
  NeighbourSearch(const cv::Mat& before, const cv::Mat& after, float sigma)
      : before_(before), after_(after), noise_(kNoiseFactor * 3 * kPixels * sigma * sigma / 4) {}

  // Displacement of the square around `p`; (0, 0) if it is not found.
  cv::Point motion_of(const cv::Point& p) const {
    const float contrast = contrast_of(before_, p);
    if (contrast < std::max(kLeastContrast * kPixels, 2 * noise_)) return {};
    float best = std::max(noise_, kLeftPart * contrast);
    cv::Point motion;
    const cv::Rect room(kPatch, kPatch, after_.cols - 2 * kPatch, after_.rows - 2 * kPatch);
    for (int dy = -kReach; dy <= kReach; ++dy)
      for (int dx = -kReach; dx <= kReach; ++dx) {
        const cv::Point q = p + cv::Point(dx, dy);
        if (!room.contains(q)) continue;
        const float left = mismatch(before_, p, after_, q, best);
        if (left >= best) continue;
        best = left;
        motion = {dx, dy};
      }
    return motion;
  }

 private:
  static constexpr float kPixels = (2 * kPatch + 1) * (2 * kPatch + 1);

  const cv::Mat& before_;
  const cv::Mat& after_;
  float noise_;
};

bool moves_with_neighbours(const Motion& motion, const std::vector<Motion>& all) {
  int near = 0, alike = 0;
  for (const auto& other : all) {
    const cv::Point off = other.at - motion.at, by = other.by - motion.by;
    if (std::max(std::abs(off.x), std::abs(off.y)) > kNeighbourDistance) continue;
    ++near;
    alike += std::max(std::abs(by.x), std::abs(by.y)) <= 1 && other.by != cv::Point();
  }
  return alike >= kFewestAlike && alike >= kPartAlike * near;
}

}  // namespace

cv::Mat moved_neighbours(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                         float sigma) {
  const cv::Mat b = imaging::half_size(before, cv::INTER_AREA),
                a = imaging::half_size(after, cv::INTER_AREA);
  const cv::Mat marked = imaging::half_size(changed, cv::INTER_NEAREST);
  const NeighbourSearch search(b, a, sigma);
  std::vector<Motion> motions;
  for (int y = kPatch; y < b.rows - kPatch; y += kStride)
    for (int x = kPatch; x < b.cols - kPatch; x += kStride)
      if (marked.at<uchar>(y, x)) motions.push_back({{x, y}, search.motion_of({x, y})});
  cv::Mat moved = cv::Mat::zeros(b.size(), CV_8UC1), result;
  for (const auto& motion : motions)
    if (motion.by != cv::Point() && moves_with_neighbours(motion, motions))
      moved(
          cv::Rect(motion.at - cv::Point(kPatch, kPatch), cv::Size(2 * kPatch + 1, 2 * kPatch + 1)))
          .setTo(255);
  cv::resize(moved, result, changed.size(), 0, 0, cv::INTER_NEAREST);
  return result & changed;
}

}  // namespace mbncc::change
