// SPDX-License-Identifier: BSD-3-Clause
// Small seeded images for the tests of learning: a textured platform, a textured object, noise.
#pragma once

#include <gtest/gtest.h>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mbncc/learning/learn_object.hpp"

namespace mbncc::test {

/// Smooth random texture with about the given colour; `contrast` in grey levels.
inline cv::Mat texture(cv::Size size, cv::Scalar colour, double contrast, int seed,
                       double grain = 3) {
  cv::RNG random(seed);
  cv::Mat noise(size, CV_32FC3), image;
  random.fill(noise, cv::RNG::NORMAL, 0, 1);
  cv::GaussianBlur(noise, noise, {}, grain);
  cv::Scalar mean, deviation;
  cv::meanStdDev(noise, mean, deviation);
  noise *= contrast / deviation[0];
  cv::add(noise, colour, image);
  return image;
}

/// Adds camera noise and converts to 8 bits.
inline cv::Mat exposed(const cv::Mat& radiance, int seed, double gain = 1, double sigma = 2) {
  cv::RNG random(seed);
  cv::Mat noise(radiance.size(), CV_32FC3), image;
  random.fill(noise, cv::RNG::NORMAL, 0, sigma);
  cv::Mat values = radiance * gain + noise;
  values.convertTo(image, CV_8UC3);
  return image;
}

/// A lesson whose true map is known.
struct DrawnLesson {
  Lesson lesson;
  cv::Mat truth;
  cv::Mat platform;  ///< CV_32FC3
  cv::Mat scene;     ///< CV_32FC3, with the object
};

inline cv::Mat wedge_map(cv::Size size, cv::Point at) {
  cv::Mat map = cv::Mat::zeros(size, CV_8UC1);
  const std::vector<cv::Point> corners{at + cv::Point(-34, -18), at + cv::Point(38, -26),
                                       at + cv::Point(30, 4),    at + cv::Point(8, 10),
                                       at + cv::Point(2, 32),    at + cv::Point(-26, 24)};
  cv::fillPoly(map, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return map;
}

inline DrawnLesson draw_lesson(cv::Point at = {120, 100}, cv::Size size = {240, 200}) {
  DrawnLesson drawn;
  drawn.platform = texture(size, cv::Scalar(105, 115, 120), 14, 1);
  drawn.truth = wedge_map(size, at);
  drawn.scene = drawn.platform.clone();
  texture(size, cv::Scalar(60, 90, 190), 22, 2).copyTo(drawn.scene, drawn.truth);
  cv::GaussianBlur(drawn.scene, drawn.scene, {}, 0.7);
  drawn.lesson.before = exposed(drawn.scene, 11);
  drawn.lesson.after = exposed(drawn.platform, 12);
  drawn.lesson.region = cv::Rect(at.x - 48, at.y - 40, 100, 84) & cv::Rect({0, 0}, size);
  drawn.lesson.name = "wedge";
  return drawn;
}

/// Error of a lesson that must fail with a reason and a remedy.
inline LearnError error_for(const Lesson& lesson) {
  const LearnResult result = learn_object(lesson);
  EXPECT_FALSE(result.message.empty());
  EXPECT_FALSE(result.hint.empty());
  return result.error;
}

inline cv::Mat map_of(const LearnResult& result) {
  return full_size_map(result.object.views.front());
}

inline double iou(const cv::Mat& a, const cv::Mat& b) {
  return cv::countNonZero(a & b) / static_cast<double>(cv::countNonZero(a | b));
}

}  // namespace mbncc::test
