// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/pinhole_camera.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr double kShortestFocus = 0.1, kLongestFocus = 100;  // in longer sides of the image
constexpr double kMostAspect = 2;  // largest ratio of the two focal lengths
// Largest distance of the principal point from the image, as a part of the image's size.
constexpr double kFarthestPrincipalPoint = 0.5;
constexpr double kMatrixTolerance = 1e-6;  // of entries that must be 0 or 1

bool is_nearly(double value, double wanted) {
  return std::abs(value - wanted) <= kMatrixTolerance;
}

/// Whether the coordinate lies at most kFarthestPrincipalPoint of the image's size outside the
/// image.
bool is_near(double place, int size) {
  return place >= -kFarthestPrincipalPoint * size && place <= (1 + kFarthestPrincipalPoint) * size;
}

}  // namespace

std::string fault_of_camera(const cv::Matx33d& matrix, cv::Size calibrated) {
  if (calibrated.empty()) return "the image has no size";
  if (!cv::checkRange(matrix)) return "a number is not finite";
  if (!is_nearly(matrix(2, 0), 0) || !is_nearly(matrix(2, 1), 0) || !is_nearly(matrix(2, 2), 1))
    return "the last row is not 0 0 1";
  if (!is_nearly(matrix(0, 1), 0) || !is_nearly(matrix(1, 0), 0)) return "the pixels are skewed";
  const double fx = matrix(0, 0), fy = matrix(1, 1);
  const double side = std::max(calibrated.width, calibrated.height);
  for (const double focus : {fx, fy}) {
    if (!(focus >= kShortestFocus * side))
      return "the focal length is shorter than a tenth of the image";
    if (focus > kLongestFocus * side) return "the focal length is longer than a hundred images";
  }
  if (fx > kMostAspect * fy || fy > kMostAspect * fx)
    return "one focal length is more than twice the other";
  if (!is_near(matrix(0, 2), calibrated.width) || !is_near(matrix(1, 2), calibrated.height))
    return "the principal point lies far outside the image";
  return "";
}

std::optional<PinholeCamera> usable_camera(const cv::Matx33d& matrix, cv::Size calibrated,
                                           cv::Size image) {
  if (calibrated != image || !fault_of_camera(matrix, calibrated).empty()) return std::nullopt;
  return PinholeCamera{matrix(0, 0), matrix(1, 1), matrix(0, 2), matrix(1, 2)};
}

PixelToRay rays_of(const PinholeCamera& camera) {
  return [camera](cv::Point2d pixel) {
    return cv::Vec3d((pixel.x - camera.cx) / camera.fx, (pixel.y - camera.cy) / camera.fy, 1);
  };
}

}  // namespace mbncc
