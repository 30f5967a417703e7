// SPDX-License-Identifier: BSD-3-Clause
// Random object models from a seed, and their comparison.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>

#include "mbncc/object_model.hpp"

namespace mbncc::test {

inline View random_view(std::mt19937& random, int largest_side = 60) {
  const auto between = [&random](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
  };
  View view;
  const cv::Size size(between(1, largest_side), between(1, largest_side));
  view.template_image.create(size, CV_8UC3);
  cv::RNG noise(random());
  noise.fill(view.template_image, cv::RNG::UNIFORM, 0, 256);
  view.map.create(size, CV_8UC1);
  noise.fill(view.map, cv::RNG::UNIFORM, 0, 2);
  view.map *= 255;
  view.map.at<std::uint8_t>(0, 0) = 255;
  view.origin = {between(0, 500), between(0, 400)};
  view.image_size = cv::Size(view.origin) + size + cv::Size(between(0, 50), between(0, 50));
  std::normal_distribution<double> normal(0, 100);
  view.reference = {normal(random), normal(random), normal(random) / 100};
  return view;
}

/// An object whose fields are set or left out at random.
inline ObjectModel random_model(unsigned seed, const std::string& name = "wrench",
                                int largest_side = 60) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  ObjectModel model;
  model.name = name;
  model.label = "M\xc3\xbcller's \"wrench\" #" + std::to_string(seed) + ": [10 mm]";
  model.enabled = unit(random) < 0.5;
  model.learned_at = 1.7e9 + 1e6 * unit(random);
  if (unit(random) < 0.5) model.metres_per_pixel = unit(random) / 1000;
  model.object_height = unit(random) / 10;
  if (unit(random) < 0.5)
    model.grasp = Grasp{{unit(random), -unit(random), 1e-7}, {0, 0, 0.6, 0.8}};
  if (unit(random) < 0.5) model.min_score = unit(random);
  model.quality.verdict = static_cast<Verdict>(random() % 3);
  model.quality.reasons = {"low_texture", "symmetric_180"};
  model.quality.advice = {"Turn it: \"marked\" side up.", ""};
  model.quality.area = std::floor(1000 * unit(random));
  model.quality.self_score = unit(random);
  model.quality.symmetry = static_cast<int>(random() % 5);
  if (unit(random) < 0.5) model.quality.change_agreement = unit(random);
  if (unit(random) < 0.5) model.quality.outline_probability = unit(random);
  model.quality.search_time = unit(random);
  if (seed % 3 == 0) model.taught_by = "robot \"7\"/left";
  if (seed % 2 == 0) model.symmetry = static_cast<int>(seed / 2 % 13);
  for (unsigned i = 0; i <= random() % 4; ++i)
    model.views.push_back(random_view(random, largest_side));
  return model;
}

inline bool same_pixels(const cv::Mat& a, const cv::Mat& b) {
  return a.size() == b.size() && a.type() == b.type() && cv::norm(a, b, cv::NORM_INF) == 0;
}

inline void expect_same_number(double a, double b) {
  EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << a << " and " << b;
}

inline void expect_equal(const View& a, const View& b) {
  EXPECT_TRUE(same_pixels(a.template_image, b.template_image));
  EXPECT_TRUE(same_pixels(a.map, b.map));
  EXPECT_EQ(a.origin, b.origin);
  EXPECT_EQ(a.image_size, b.image_size);
  EXPECT_EQ(a.reference.x, b.reference.x);
  EXPECT_EQ(a.reference.y, b.reference.y);
  EXPECT_EQ(a.reference.theta, b.reference.theta);
}

inline void expect_equal(const Quality& a, const Quality& b) {
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.reasons, b.reasons);
  EXPECT_EQ(a.advice, b.advice);
  EXPECT_EQ(a.symmetry, b.symmetry);
  EXPECT_EQ(a.confusable_with, b.confusable_with);
  expect_same_number(a.area, b.area);
  expect_same_number(a.self_score, b.self_score);
  expect_same_number(a.change_agreement, b.change_agreement);
  expect_same_number(a.outline_probability, b.outline_probability);
  expect_same_number(a.search_time, b.search_time);
}

/// Compares everything except the revision.
inline void expect_equal(const ObjectModel& a, const ObjectModel& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.label, b.label);
  EXPECT_EQ(a.enabled, b.enabled);
  EXPECT_EQ(a.learned_at, b.learned_at);
  EXPECT_EQ(a.taught_by, b.taught_by);
  expect_same_number(a.metres_per_pixel, b.metres_per_pixel);
  EXPECT_EQ(a.object_height, b.object_height);
  ASSERT_EQ(a.grasp.has_value(), b.grasp.has_value());
  if (a.grasp) {
    EXPECT_EQ(a.grasp->position, b.grasp->position);
    EXPECT_EQ(a.grasp->orientation, b.grasp->orientation);
  }
  EXPECT_EQ(a.min_score, b.min_score);
  EXPECT_EQ(a.symmetry, b.symmetry);
  expect_equal(a.quality, b.quality);
  ASSERT_EQ(a.views.size(), b.views.size());
  for (std::size_t i = 0; i < a.views.size(); ++i) expect_equal(a.views[i], b.views[i]);
}

}  // namespace mbncc::test
