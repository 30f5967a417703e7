// SPDX-License-Identifier: BSD-3-Clause
#include "learning/alignment/camera_shift.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/half_size.hpp"
#include "imaging/strips.hpp"
#include "numeric/order_statistics.hpp"

namespace mbncc::alignment {
namespace {

constexpr double kEnough = 8000;            // samples that suffice
constexpr std::size_t kFewest = 200;        // samples; with fewer, no shift is estimated
constexpr std::size_t kSmallImage = 10000;  // [px] largest area of the coarsest level
constexpr int kRounds = 6;                  // most Gauss-Newton steps at each level
constexpr double kLongestStep = 2;          // [px] longest step, the range of the linearisation
constexpr double kConverged = 0.01;         // [px] a shorter step is the last one
constexpr double kWorthwhile = 0.04;        // [px] smaller shifts are not compensated
constexpr double kClearGain = 0.98;         // a shift must reduce the cost below this part
constexpr double kLeastSpread = 0.3;        // [grey levels] least spread of the residuals

// Both images and their comparable pixels, at one pyramid level.
struct Level {
  cv::Mat before, after;  // CV_32FC1
  cv::Mat trusted;        // CV_8UC1
};

Level coarser(const Level& level) {
  return {imaging::half_size(level.before, cv::INTER_AREA),
          imaging::half_size(level.after, cv::INTER_AREA),
          imaging::half_size(level.trusted, cv::INTER_NEAREST)};
}

// Bilinear interpolation with the same sub-pixel offset for all pixels.
class Shifted {
 public:
  Shifted(const cv::Mat& image, const cv::Point2d& shift)
      : image_(image), left_(cvFloor(shift.x)), top_(cvFloor(shift.y)) {
    const auto u = static_cast<float>(shift.x - left_), v = static_cast<float>(shift.y - top_);
    weights_ = {(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v};
  }

  float operator()(int y, int x) const {
    const int row = y + top_, column = x + left_;
    if (row >= 0 && row + 1 < image_.rows && column >= 0 && column + 1 < image_.cols)
      return interpolated(image_.ptr<float>(row) + column, image_.ptr<float>(row + 1) + column);
    return at_border(y, x);
  }

 private:
  float interpolated(const float* upper, const float* lower) const {
    return weights_[0] * upper[0] + weights_[1] * upper[1] + weights_[2] * lower[0] +
           weights_[3] * lower[1];
  }

  float at_border(int y, int x) const {
    const float* upper = image_.ptr<float>(std::clamp(y + top_, 0, image_.rows - 1));
    const float* lower = image_.ptr<float>(std::clamp(y + top_ + 1, 0, image_.rows - 1));
    const int near = std::clamp(x + left_, 0, image_.cols - 1);
    const int far = std::clamp(x + left_ + 1, 0, image_.cols - 1);
    return weights_[0] * upper[near] + weights_[1] * upper[far] + weights_[2] * lower[near] +
           weights_[3] * lower[far];
  }

  const cv::Mat& image_;
  int left_, top_;
  cv::Vec4f weights_;
};

struct Cost {
  double value = 0;   // mean of residuals, clipped at three standard deviations
  double spread = 0;  // [grey levels] robust standard deviation of the residuals
};

// The shift between the images of one level.
class ShiftFit {
 public:
  explicit ShiftFit(const Level& level) : level_(level) {
    const int step = std::max(1, cvRound(std::sqrt(cv::countNonZero(level.trusted) / kEnough)));
    for (int y = 1; y < level.trusted.rows - 1; y += step)
      for (int x = 1; x < level.trusted.cols - 1; x += step)
        if (level.trusted.at<uchar>(y, x)) samples_.emplace_back(x, y);
  }

  bool usable() const { return samples_.size() >= kFewest; }

  Cost cost_of(const cv::Point2d& shift) const {
    const Shifted after(level_.after, shift);
    std::vector<float> residuals;
    residuals.reserve(samples_.size());
    for (const auto& at : samples_)
      residuals.push_back(std::abs(level_.before.at<float>(at) - after(at.y, at.x)));
    Cost cost;
    cost.spread =
        std::max<double>(kLeastSpread, numeric::deviation_of_mad(numeric::median(residuals)));
    for (const float r : residuals) cost.value += std::min<double>(r, 3 * cost.spread);
    cost.value /= static_cast<double>(residuals.size());
    return cost;
  }

  cv::Point2d refined(cv::Point2d shift) const {
    for (int round = 0; round < kRounds; ++round) {
      const cv::Point2d step = step_from(shift, cost_of(shift).spread);
      shift += step;
      if (cv::norm(step) < kConverged) break;
    }
    return shift;
  }

 private:
  // One Gauss-Newton step with Tukey weights; a weak prior stabilises it where the scene has no
  // texture.
  cv::Point2d step_from(const cv::Point2d& shift, double spread) const {
    const Shifted after(level_.after, shift);
    cv::Matx22d normal = cv::Matx22d::zeros();
    cv::Vec2d right(0, 0);
    double samples = 0;
    for (const auto& at : samples_) {
      const double residual = level_.before.at<float>(at) - after(at.y, at.x);
      const double r = residual / (4 * spread);
      if (std::abs(r) >= 1) continue;
      const double weight = (1 - r * r) * (1 - r * r);
      const double gx = (after(at.y, at.x + 1) - after(at.y, at.x - 1)) / 2;
      const double gy = (after(at.y + 1, at.x) - after(at.y - 1, at.x)) / 2;
      normal += weight * cv::Matx22d(gx * gx, gx * gy, gx * gy, gy * gy);
      right += weight * residual * cv::Vec2d(gx, gy);
      samples += weight;
    }
    normal += cv::Matx22d::eye() * (0.5 * samples);
    const cv::Vec2d step = normal.solve(right, cv::DECOMP_CHOLESKY);
    const double length = cv::norm(step);
    return cv::Point2d(step[0], step[1]) * (length > kLongestStep ? kLongestStep / length : 1);
  }

  const Level& level_;
  std::vector<cv::Point> samples_;
};

// From coarse to fine, because in fine texture Gauss-Newton would converge to a local optimum.
cv::Point2d shift_of(const Level& level) {
  cv::Point2d start;
  if (level.before.total() > kSmallImage) start = 2 * shift_of(coarser(level));
  const ShiftFit fit(level);
  return fit.usable() ? fit.refined(start) : start;
}

}  // namespace

cv::Mat smooth_luminance(const cv::Mat& image) {
  cv::Mat luminance(image.size(), CV_32FC1), strip;
  imaging::for_each_strip(image.rows, [&](const cv::Range& rows) {
    image.rowRange(rows).convertTo(strip, CV_32F);
    cv::Mat part = luminance.rowRange(rows);
    cv::cvtColor(strip, part, cv::COLOR_BGR2GRAY);
  });
  cv::GaussianBlur(luminance, luminance, {}, 1.5);
  return luminance;
}

cv::Point2d estimate_shift(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted,
                           double max_shift) {
  const Level level{before, after, trusted};
  const ShiftFit fit(level);
  if (!fit.usable()) return {};
  const cv::Point2d shift = shift_of(level);
  if (cv::norm(shift) > max_shift || cv::norm(shift) < kWorthwhile) return {};
  return fit.cost_of(shift).value < kClearGain * fit.cost_of({}).value ? shift : cv::Point2d();
}

}  // namespace mbncc::alignment
