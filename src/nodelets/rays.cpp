#include "nodelets/rays.hpp"

#include <image_geometry/pinhole_camera_model.h>
#include <sensor_msgs/distortion_models.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <vector>

namespace mbncc::nodelets {
namespace {

constexpr double kMostMisfit = 0.01;  // [px] of a ray projected back
constexpr int kIterations = 100;      // OpenCV's default of 5 leaves a tenth of a pixel

cv::Matx33d camera_matrix(const sensor_msgs::CameraInfo& info, bool rectified) {
  if (!rectified) return cv::Matx33d(info.K.data());
  const auto& p = info.P;
  return {p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]};
}

bool all_finite(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

/// No distortion, or a model that can be undone.
bool is_known_lens(const sensor_msgs::CameraInfo& info) {
  namespace models = sensor_msgs::distortion_models;
  const bool straight =
      std::all_of(info.D.begin(), info.D.end(), [](double value) { return value == 0; });
  return straight || info.distortion_model == models::PLUMB_BOB ||
         info.distortion_model == models::RATIONAL_POLYNOMIAL;
}

/// The calibration with R = 1 and P = K: rectifying leaves nothing but the distortion to undo.
sensor_msgs::CameraInfo without_turn(const sensor_msgs::CameraInfo& info) {
  auto plain = info;
  const auto& k = info.K;
  plain.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  plain.P = {k[0], k[1], k[2], 0, k[3], k[4], k[5], 0, k[6], k[7], k[8], 0};
  return plain;
}

/// Rays through the pixels of a raw picture, directions in the optical frame.
class DistortedRays {
 public:
  explicit DistortedRays(const image_geometry::PinholeCameraModel& model) : model_(model) {}

  cv::Vec3d operator()(cv::Point2d pixel) const {
    const cv::Point2d straight = undistorted(pixel);
    const cv::Point2d back = model_.unrectifyPoint(straight);
    // Far out a model may fold over, where no ray leads to the pixel.
    if (!(cv::norm(back - pixel) < kMostMisfit))
      return cv::Vec3d::all(std::numeric_limits<double>::quiet_NaN());
    return cv::Vec3d(model_.projectPixelTo3dRay(straight));
  }

 private:
  cv::Point2d undistorted(cv::Point2d pixel) const {
    if (model_.distortionCoeffs().empty()) return pixel;
    const std::vector<cv::Point2d> raw{pixel};
    std::vector<cv::Point2d> straight;
    const cv::Matx33d k = model_.intrinsicMatrix();
    cv::undistortPoints(raw, straight, k, model_.distortionCoeffs(), cv::noArray(), k,
                        {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, kIterations, 1e-10});
    return straight.front();
  }

  image_geometry::PinholeCameraModel model_;
};

std::optional<PixelToRay> distorted_rays(const sensor_msgs::CameraInfo& info) {
  image_geometry::PinholeCameraModel model;
  if (!all_finite(info.D) || !is_known_lens(info) || !model.fromCameraInfo(without_turn(info)))
    return {};
  return DistortedRays(model);
}

}  // namespace

std::optional<PixelToRay> rays_of(const sensor_msgs::CameraInfo& info, bool rectified,
                                  cv::Size size) {
  const cv::Size calibrated(static_cast<int>(info.width), static_cast<int>(info.height));
  const auto camera = usable_camera(camera_matrix(info, rectified), calibrated, size);
  if (!camera) return {};
  return rectified ? mbncc::rays_of(*camera) : distorted_rays(info);
}

}  // namespace mbncc::nodelets
