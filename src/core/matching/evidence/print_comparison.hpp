// SPDX-License-Identifier: BSD-3-Clause
// Compares an object's print, the colours inside its outline, with an image, pixel by pixel.
#pragma once

#include <opencv2/core.hpp>

#include "matching/evidence/lesson_pixels.hpp"
#include "matching/scene/scene_level.hpp"
#include "matching/template/pose_sample.hpp"
#include "mbncc/geometry.hpp"

namespace mbncc::evidence {

/// Largest connected groups of pixels whose colour, in the light of the image, does not occur
/// within 2 px in the other of lesson and image: their numbers of pixels in the lesson's frame,
/// divided by the square root of the area inside. Only groups beside which most of the outline is
/// found count: an occluder hides the outline. Highlights, as defined in surface_template.hpp, do
/// not count.
struct PrintDifference {
  double largest = 0;
  double enclosed = 0;  ///< of the groups that stay off the rim of the compared area
};

class PrintComparison {
 public:
  PrintComparison() = default;

  /// The parameters are those of LessonCrop.
  PrintComparison(const scene::SceneLevel& lesson, const cv::Mat& map, cv::Point2d anchor);

  /// Compares the object with its anchor at `pose`, `scale` times as large as in the lesson.
  /// `sample` was read there with `object`, a template of the view.
  PrintDifference difference(const scene::SceneLevel& scene, const templates::PoseTemplate& object,
                             const templates::PoseSample& sample, const Pose2D& pose,
                             double scale) const;

  /// PrintDifference::largest of the colours relative to those around them. Light changes gradually
  /// and prints do not, so smaller differences of fine prints count.
  double difference_in_detail(const scene::SceneLevel& scene, const templates::PoseTemplate& object,
                              const templates::PoseSample& sample, const Pose2D& pose,
                              double scale) const;

 private:
  /// Logarithmic colours of the image and the lesson, in the light of the image.
  struct Colours {
    cv::Mat seen, learned;  ///< CV_8UC3
    cv::Mat compared;       ///< CV_8UC1: 255 inside the outline and the image, off highlights
  };

  Colours colours_at(const scene::SceneLevel& scene, const templates::PoseTemplate& object,
                     const templates::PoseSample& sample, const Pose2D& pose, double scale) const;
  PrintDifference largest_difference(const cv::Mat& differing, const cv::Mat& compared,
                                     const templates::PoseTemplate& object,
                                     const templates::PoseSample& sample) const;

  LessonCrop lesson_;
};

}  // namespace mbncc::evidence
