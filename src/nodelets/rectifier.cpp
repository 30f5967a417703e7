#include "nodelets/rectifier.hpp"

#include <opencv2/imgproc.hpp>

#include "nodelets/rays.hpp"

namespace mbncc::nodelets {

Rectified Rectifier::rectify(const cv::Mat& picture, const sensor_msgs::CameraInfo& info) {
  if (!rays_of(info, true, picture.size()) || !rays_of(info, false, picture.size()))
    return {{}, "camera_info is not usable for pictures of this size; calibrate the camera"};
  Rectified rectified;
  model_.fromCameraInfo(info);
  model_.rectifyImage(picture, rectified.picture, cv::INTER_LINEAR);
  return rectified;
}

}  // namespace mbncc::nodelets
