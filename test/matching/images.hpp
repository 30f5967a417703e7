// SPDX-License-Identifier: BSD-3-Clause
// Seeded images for the tests of matching: a smooth random texture as object and as background.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "mbncc/geometry.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::test {

/// CV_8UC3 random texture whose grains are about `grain` pixels wide.
inline cv::Mat texture(cv::Size size, std::uint64_t seed, double grain = 3) {
  cv::Mat noise(size, CV_32FC3), smooth;
  cv::RNG random(seed);
  random.fill(noise, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(noise, smooth, {}, grain);
  cv::Scalar mean, deviation;
  cv::meanStdDev(smooth, mean, deviation);
  smooth = (smooth - mean) * (40 / deviation[0]) + cv::Scalar::all(120);
  cv::Mat image;
  smooth.convertTo(image, CV_8U);
  return image;
}

/// The image with the rows from `from` on displaced by `way` [px].
inline cv::Mat torn(const cv::Mat& image, int from, double way) {
  cv::Mat moved, result = image.clone();
  cv::warpAffine(image, moved, cv::Matx23d(1, 0, way, 0, 1, 0), image.size(), cv::INTER_LINEAR,
                 cv::BORDER_REPLICATE);
  moved.rowRange(from, moved.rows).copyTo(result.rowRange(from, moved.rows));
  return result;
}

/// An L-shaped map with no symmetry, about 70 px long, centred in 120 x 120 pixels.
inline cv::Mat angle_map() {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(35, 25, 24, 70)) = 255;
  map(cv::Rect(35, 73, 52, 22)) = 255;
  return map;
}

/// The learning image of an object: its texture under the map, another one around it.
struct LearningImage {
  explicit LearningImage(std::uint64_t seed, const cv::Mat& object_map = angle_map())
      : map(object_map), surface(texture(map.size(), seed)) {
    texture(map.size(), seed + 1000, 5).copyTo(image);
    surface.copyTo(image, map);
  }

  cv::Mat map, surface, image;
};

/// The object turned over, so that it appears mirrored.
inline LearningImage mirrored(const LearningImage& source) {
  LearningImage other(1);
  cv::flip(source.map, other.map, 1);
  cv::flip(source.surface, other.surface, 1);
  cv::flip(source.image, other.image, 1);
  return other;
}

inline std::shared_ptr<ObjectModel> object_from(const LearningImage& source,
                                                const Pose2D& reference,
                                                const std::string& name = "object") {
  auto model = std::make_shared<ObjectModel>();
  model->name = name;
  model->views.push_back(crop_view(source.image, source.map, reference));
  return model;
}

/// Draws the object so that its learned point `reference` lies at `pose`, rotated by pose.theta.
inline void place(cv::Mat& scene, const LearningImage& source, cv::Point2d reference,
                  const Pose2D& pose) {
  const double c = std::cos(pose.theta), s = std::sin(pose.theta);
  const cv::Matx23d to_scene(c, -s, pose.x - c * reference.x + s * reference.y,  //
                             s, c, pose.y - s * reference.x - c * reference.y);
  cv::Mat surface, coverage;
  cv::warpAffine(source.surface, surface, to_scene, scene.size(), cv::INTER_LINEAR,
                 cv::BORDER_REFLECT);
  cv::warpAffine(source.map, coverage, to_scene, scene.size(), cv::INTER_LINEAR);
  surface.copyTo(scene, coverage > 127);
}

}  // namespace mbncc::test
