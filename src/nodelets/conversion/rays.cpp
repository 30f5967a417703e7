// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/conversion/rays.hpp"

#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <utility>
#include <vector>

#include "nodelets/conversion/camera_model.hpp"

namespace mbncc::nodelets {
namespace {

constexpr double kMaxReprojectionError = 0.01;  // [px] largest reprojection error of a ray
constexpr double kMaxTangentialAngle = 0.1;     // [rad] largest rotation about the optical axis
constexpr int kIterations = 100;  // OpenCV's default of 5 leaves an error of a tenth of a pixel
constexpr int kSteps = 64;        // number of steps from the optical axis to a ray

/// Rays through the pixels of a raw image, directions in the optical frame.
class DistortedRays {
 public:
  explicit DistortedRays(Lens lens) : lens_(std::move(lens)), k_(matrix_of(lens_.camera)) {}

  cv::Vec3d operator()(cv::Point2d pixel) const {
    const cv::Point2d straight = undistorted(pixel);
    if (has_tangential_excess(straight, pixel) || !projects_to(straight, pixel))
      return cv::Vec3d::all(std::numeric_limits<double>::quiet_NaN());
    return {straight.x, straight.y, 1};
  }

 private:
  /// The x and y of the direction (x, y, 1) of the ray through a raw pixel.
  cv::Point2d undistorted(cv::Point2d pixel) const {
    const std::vector<cv::Point2d> raw{pixel};
    std::vector<cv::Point2d> straight;
    if (lens_.is_fisheye)
      cv::fisheye::undistortPoints(raw, straight, k_, lens_.distortion);
    else
      cv::undistortPoints(raw, straight, k_, lens_.distortion, cv::noArray(), cv::noArray(),
                          {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kIterations, 1e-10});
    return straight.front();
  }

  std::vector<cv::Point2d> distorted(const std::vector<cv::Point2d>& directions) const {
    std::vector<cv::Point2d> pixels;
    if (lens_.is_fisheye) {
      cv::fisheye::distortPoints(directions, pixels, k_, lens_.distortion);
      return pixels;
    }
    std::vector<cv::Point3d> points;
    for (const auto& direction : directions) points.emplace_back(direction.x, direction.y, 1);
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), k_, lens_.distortion, pixels);
    return pixels;
  }

  /// Whether the pixel is displaced too far sideways. Lenses displace pixels radially; decentred
  /// ones also slightly sideways.
  bool has_tangential_excess(cv::Point2d direction, cv::Point2d pixel) const {
    const auto& camera = lens_.camera;
    const cv::Point2d seen((pixel.x - camera.cx) / camera.fx, (pixel.y - camera.cy) / camera.fy);
    return std::abs(seen.cross(direction)) >
           kMaxTangentialAngle * cv::norm(seen) * cv::norm(direction);
  }

  /// Whether the direction belongs to a valid ray through the pixel: from the axis to it, the
  /// radius of the pixels must increase monotonically. Far from the axis a distortion model may
  /// fold over, so that a pixel has no ray or a wrong one.
  bool projects_to(cv::Point2d direction, cv::Point2d pixel) const {
    std::vector<cv::Point2d> directions;
    // The points are denser near the axis, where a fold may be narrow.
    for (int i = 0; i <= kSteps; ++i)
      directions.push_back(direction * (double(i * i) / (kSteps * kSteps)));
    const auto pixels = distorted(directions);
    if (!(cv::norm(pixels.back() - pixel) < kMaxReprojectionError)) return false;
    const cv::Point2d outwards = pixel - pixels.front();
    for (int i = 1; i <= kSteps; ++i)
      if (!((pixels[i] - pixels[i - 1]).dot(outwards) >= 0)) return false;
    return true;
  }

  Lens lens_;
  cv::Matx33d k_;
};

}  // namespace

std::optional<PixelToRay> rays_of(const sensor_msgs::CameraInfo& info, bool rectified,
                                  cv::Size size) {
  if (!fault_of_calibration(info, rectified, size).empty()) return {};
  if (rectified) return mbncc::rays_of(rectified_camera_of(info));
  const Lens lens = lens_of(info);
  return lens.distortion.empty() ? mbncc::rays_of(lens.camera) : DistortedRays(lens);
}

}  // namespace mbncc::nodelets
