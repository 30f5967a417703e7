// SPDX-License-Identifier: BSD-3-Clause
// Plane geometry: poses in the image, circles around a map.
// Axes: x right, y down, pixel centres at integers. theta > 0 turns x towards y, which is clockwise
// on screen and right-handed about the optical axis (REP 103).
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Position and rotation angle in an image.
struct Pose2D {
  double x = 0;      ///< [px]
  double y = 0;      ///< [px]
  double theta = 0;  ///< [rad] clockwise on screen

  cv::Point2d position() const { return {x, y}; }
};

/// A circle in image coordinates.
struct Circle {
  cv::Point2d centre;  ///< [px]
  double radius = 0;   ///< [px]
};

constexpr double kPi = 3.14159265358979323846;

constexpr double to_degrees(double radians) {
  return radians * 180.0 / kPi;
}
constexpr double to_radians(double degrees) {
  return degrees * kPi / 180.0;
}

/// Angle wrapped into (-pi, pi].
double wrap_angle(double radians);

/// Smallest difference of two angles under a rotational symmetry. `symmetry` is the number of equal
/// positions in a turn (1: none, 2: 180 degrees ...); 0 means round, with difference 0.
double angle_distance(double a, double b, int symmetry = 1);

/// `point` rotated clockwise by `theta` about the origin.
cv::Point2d rotate(cv::Point2d point, double theta);

/// Maps a point from the frame of `pose` to the image: R(theta) point + (x, y).
cv::Point2d transform(const Pose2D& pose, cv::Point2d point);

/// Applies transform() with one pose to many points.
class Transform {
 public:
  explicit Transform(const Pose2D& pose);

  cv::Point2d operator()(cv::Point2d point) const {
    return {cos_ * point.x - sin_ * point.y + x_, sin_ * point.x + cos_ * point.y + y_};
  }

 private:
  double cos_, sin_, x_, y_;
};

/// transform() as a matrix, for cv::warpAffine().
cv::Matx23d matrix_of(const Pose2D& pose);

/// Pose of the inner frame in the parent of the outer one: transform(compose(a, b), p) =
/// transform(a, transform(b, p)).
Pose2D compose(const Pose2D& outer, const Pose2D& inner);

Pose2D inverse(const Pose2D& pose);

/// Covariance of the pose (x, y, theta) of a frame that lies `lever` [px] off the one with
/// `covariance` and is rotated with it.
cv::Matx33d covariance_at(const cv::Matx33d& covariance, cv::Point2d lever);

/// Mean position of the non-zero pixels. Throws std::invalid_argument if `map` has none.
cv::Point2d centroid(const cv::Mat& map);

/// Smallest circle that contains the centres of all map pixels (the paper's term, doi
/// 10.1177/1687814017728839). Throws std::invalid_argument if `map` has no pixels.
Circle excircle(const cv::Mat& map);

/// [px] Distance from `from` to the centre of the map's farthest pixel; 0 for an empty map.
double farthest_pixel(const cv::Mat& map, cv::Point2d from);

/// Largest circle that contains only map pixels. Throws std::invalid_argument if `map` has no
/// pixels.
Circle incircle(const cv::Mat& map);

/// True if `map` is a non-empty CV_8UC1 image that contains only 0 and 255.
bool is_binary_map(const cv::Mat& map);

}  // namespace mbncc
