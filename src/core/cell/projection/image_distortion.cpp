// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/image_distortion.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

namespace mbncc {
namespace {

constexpr int kPlaces = 3;  // sampled places per side of the image
// Between random places and directions of slim to compact objects, for tilts of 2 to 20 degrees and
// for distorting lenses, the actual errors are 0.7 to 1.1 times the errors by these factors
// (image_distortion_test.cpp).
constexpr double kYawError = 1.1;         // [rad] per shear; for two places and slim objects
constexpr double kPositionError = 0.032;  // per bend and squared length of the object

/// Root mean square of the added values.
class MeanSquare {
 public:
  void add(double value) {
    sum_ += value * value;
    ++count_;
  }
  double root() const { return count_ == 0 ? 0 : std::sqrt(sum_ / count_); }

 private:
  double sum_ = 0;
  int count_ = 0;
};

/// How the position on the platform changes along a line in the image.
struct Along {
  cv::Vec3d slope;  // [m/px]
  double bend = 0;  // [1/px]
};

/// `at` [m] is the platform's point seen at `place` [px]; the line goes from `place` - `step` to
/// `place` + `step`.
std::optional<Along> along(const Platform& platform, cv::Point2d place, const cv::Vec3d& at,
                           cv::Point2d step) {
  const auto before = platform.meet(place - step, 0), after = platform.meet(place + step, 0);
  if (!before || !after) return {};
  const double length = cv::norm(step);
  const cv::Vec3d slope = (*after - *before) / (2 * length);
  const double change = cv::norm(*after + *before - 2 * at) / (length * length);
  return Along{slope, change / cv::norm(slope)};
}

double shear_of(const cv::Vec3d& x, const cv::Vec3d& y) {
  // For the singular values a, b of the matrix with columns x and y: a b and a^2 + b^2.
  const double product = cv::norm(x.cross(y)), squares = x.dot(x) + y.dot(y);
  return std::sqrt(std::max(0.0, squares - 2 * product) / (squares + 2 * product));
}

}  // namespace

ImageDistortion distortion_of(const Platform& platform, cv::Size size) {
  const double width = static_cast<double>(size.width) / kPlaces;
  const double height = static_cast<double>(size.height) / kPlaces;
  MeanSquare shear, bend;
  for (int row = 0; row < kPlaces; ++row)
    for (int column = 0; column < kPlaces; ++column) {
      const cv::Point2d place((column + 0.5) * width, (row + 0.5) * height);
      const auto at = platform.meet(place, 0);
      if (!at) continue;
      const auto x = along(platform, place, *at, {width / 4, 0});
      const auto y = along(platform, place, *at, {0, height / 4});
      if (!x || !y) continue;
      shear.add(shear_of(x->slope, y->slope));
      bend.add(x->bend);
      bend.add(y->bend);
    }
  return {shear.root(), bend.root()};
}

double yaw_error_of(const ImageDistortion& distortion) {
  return kYawError * distortion.shear;
}

cv::Matx33d with_distortion(const cv::Matx33d& covariance, const ImageDistortion& distortion,
                            const std::vector<cv::Point2f>& outline) {
  const cv::Size2f size = outline.empty() ? cv::Size2f() : cv::minAreaRect(outline).size;
  const double length = std::max(size.width, size.height);
  const double position = kPositionError * distortion.bend * length * length;
  const double yaw = yaw_error_of(distortion);
  return covariance + cv::Matx33d::diag({position * position, position * position, yaw * yaw});
}

}  // namespace mbncc
