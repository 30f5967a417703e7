#include "learning/camera_shift.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/statistics.hpp"

namespace mbncc {
namespace {

constexpr int kStep = 2;                      // [px] sampling
constexpr std::size_t kFewest = 200;          // samples
constexpr std::size_t kLargePicture = 60000;  // [px]
constexpr int kRounds = 6;                    // of Gauss-Newton
constexpr double kLongestStep = 2;            // [px] the linearisation holds about so far
constexpr double kConverged = 0.02;           // [px]
constexpr double kWorthwhile = 0.04;          // [px] less is not worth an interpolation
constexpr double kClearGain = 0.98;           // of the cost without a shift
constexpr double kLeastSpread = 0.3;          // [grey levels]

cv::Mat half_size(const cv::Mat& picture, int interpolation) {
  cv::Mat half;
  cv::resize(picture, half, {}, 0.5, 0.5, interpolation);
  return half;
}

struct Cost {
  double value = 0;   // mean of residuals, capped at three spreads
  double spread = 0;  // [grey levels]
  bool usable = false;
};

template <class Visit>
void for_each_sample(const cv::Mat& trusted, Visit&& visit) {
  for (int y = kStep; y < trusted.rows - kStep; y += kStep)
    for (int x = kStep; x < trusted.cols - kStep; x += kStep)
      if (trusted.at<uchar>(y, x)) visit(y, x);
}

Cost cost_of(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted) {
  std::vector<float> residuals;
  for_each_sample(trusted, [&](int y, int x) {
    residuals.push_back(std::abs(before.at<float>(y, x) - after.at<float>(y, x)));
  });
  Cost cost;
  if (residuals.size() < kFewest) return cost;
  cost.spread = std::max<double>(kLeastSpread, deviation_of_mad(median(residuals)));
  for (const float r : residuals) cost.value += std::min<double>(r, 3 * cost.spread);
  cost.value /= static_cast<double>(residuals.size());
  cost.usable = true;
  return cost;
}

// One Gauss-Newton step with Tukey weights; a weak prior holds it where the scene has no texture.
cv::Point2d shift_step(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted,
                       double spread) {
  cv::Matx22d normal = cv::Matx22d::zeros();
  cv::Vec2d right(0, 0);
  double samples = 0;
  for_each_sample(trusted, [&](int y, int x) {
    const double residual = before.at<float>(y, x) - after.at<float>(y, x);
    const double r = residual / (4 * spread);
    if (std::abs(r) >= 1) return;
    const double weight = (1 - r * r) * (1 - r * r);
    const double gx = (after.at<float>(y, x + 1) - after.at<float>(y, x - 1)) / 2;
    const double gy = (after.at<float>(y + 1, x) - after.at<float>(y - 1, x)) / 2;
    normal += weight * cv::Matx22d(gx * gx, gx * gy, gx * gy, gy * gy);
    right += weight * residual * cv::Vec2d(gx, gy);
    samples += weight;
  });
  normal += cv::Matx22d::eye() * (0.5 * samples);
  const cv::Vec2d step = normal.solve(right, cv::DECOMP_CHOLESKY);
  const double length = cv::norm(step);
  return cv::Point2d(step[0], step[1]) * (length > kLongestStep ? kLongestStep / length : 1);
}

}  // namespace

cv::Mat smooth_luminance(const cv::Mat& picture) {
  cv::Mat luminance;
  cv::cvtColor(picture, luminance, cv::COLOR_BGR2GRAY);
  cv::GaussianBlur(luminance, luminance, {}, 1);
  return luminance;
}

cv::Mat undo_shift(const cv::Mat& picture, const cv::Point2d& shift, int interpolation) {
  const cv::Matx23d motion(1, 0, shift.x, 0, 1, shift.y);
  cv::Mat moved;
  cv::warpAffine(picture, moved, motion, picture.size(), interpolation | cv::WARP_INVERSE_MAP,
                 cv::BORDER_REPLICATE);
  return moved;
}

cv::Point2d estimate_shift(const cv::Mat& before, const cv::Mat& after, const cv::Mat& trusted,
                           double max_shift) {
  // A large picture has texture enough at half the resolution, at a quarter of the work.
  if (before.total() > kLargePicture)
    return 2 * estimate_shift(half_size(before, cv::INTER_AREA), half_size(after, cv::INTER_AREA),
                              half_size(trusted, cv::INTER_NEAREST), max_shift / 2);
  const Cost unmoved = cost_of(before, after, trusted);
  if (!unmoved.usable) return {};
  cv::Point2d shift;
  cv::Mat moved = after;
  Cost cost = unmoved;
  for (int round = 0; round < kRounds; ++round) {
    const cv::Point2d step = shift_step(before, moved, trusted, cost.spread);
    shift += step;
    if (cv::norm(shift) > max_shift) return {};
    moved = undo_shift(after, shift, cv::INTER_LINEAR);
    cost = cost_of(before, moved, trusted);
    if (cv::norm(step) < kConverged) break;
  }
  const bool better = cost.value < kClearGain * unmoved.value && cv::norm(shift) > kWorthwhile;
  return better ? shift : cv::Point2d();
}

}  // namespace mbncc
