#include "nodelets/lesson_gauge.hpp"

#include <stdexcept>

namespace mbncc::nodelets {

LessonGauge::LessonGauge(const PlatformConfig& config, const std::string& gripper_frame,
                         const CameraInput& camera, const tf2_ros::Buffer& tf)
    : config_(config), camera_(camera), tf_(tf), mark_(tf, gripper_frame) {}

void LessonGauge::mark(const std_msgs::Header& newest_picture) {
  const auto info = camera_.camera_info();
  std_msgs::Header header = newest_picture;
  // Is there a platform at all? The lesson takes it at its picture's stamp.
  header.stamp = ros::Time(0);
  const cv::Size size =
      info ? cv::Size(static_cast<int>(info->width), static_cast<int>(info->height)) : cv::Size();
  const Calibration calibration = calibrate(config_, info.get(), header, size, tf_);
  if (!calibration.platform)
    throw std::runtime_error("no grasp can be marked without scale: " + calibration.fault);
  mark_.record(camera_frame_of(config_, header), ros::Time::now());
}

std::string LessonGauge::measure(const LessonShot& shot, ObjectModel& model) const {
  const View& view = model.views.front();
  const auto live = camera_.camera_info();
  const auto* info = shot.given.width != 0 ? &shot.given : live.get();
  const bool marked = mark_.is_marked_since(shot.since);
  const Calibration calibration = calibrate(config_, info, shot.header, view.picture_size, tf_);
  if (!calibration.platform) return marked ? calibration.fault : "";
  model.metres_per_pixel =
      calibration.platform->metres_per_pixel(view.reference.position(), model.object_height)
          .value_or(Quality::kUnknown);
  if (!marked) return "";
  const auto pose = calibration.platform->lift(view.reference, {}, model.object_height);
  if (!pose) return "the object's reference point does not lie on the platform";
  model.grasp = mark_.relative_to(*pose);
  return "";
}

}  // namespace mbncc::nodelets
