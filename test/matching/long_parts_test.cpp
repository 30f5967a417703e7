// SPDX-License-Identifier: BSD-3-Clause
// Long parts: shifted along themselves, side by side, and with a reference point at one end.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "matching/images.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::test {
namespace {

void add_noise(cv::Mat& image, int seed, double sigma) {
  cv::Mat noise(image.size(), CV_16SC3), values;
  cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, sigma);
  image.convertTo(values, CV_16SC3);
  cv::Mat(values + noise).convertTo(image, CV_8UC3);
}

/// A bar of this length in the middle of a square image.
struct Bar {
  Bar(int length, int width)
      : size(length + 120, length + 120),
        middle(size.width / 2, size.height / 2),
        box(middle.x - length / 2, middle.y - width / 2, length, width),
        map(cv::Mat::zeros(size, CV_8UC1)) {
    map(box).setTo(255);
  }

  cv::Size size;
  cv::Point middle;
  cv::Rect box;
  cv::Mat map;
};

// A strip with a dot every 20 px, one end of which is covered, fits as well one dot further along.
TEST(LongParts, OneWithAPeriodIsNotGraspableOnePeriodOff) {
  const Bar bar(320, 30);
  LearningImage lesson(1, bar.map);
  lesson.surface.setTo(cv::Scalar(60, 150, 190));
  for (int x = bar.box.x + 10; x + 5 < bar.box.br().x; x += 20)
    cv::circle(lesson.surface, {x, bar.middle.y - 5}, 6, cv::Scalar(40, 60, 90), cv::FILLED);
  texture(bar.size, 1001, 5).copyTo(lesson.image);
  lesson.surface.copyTo(lesson.image, bar.map);
  add_noise(lesson.image, 1, 2);
  const cv::Point2d middle = bar.middle;
  Matcher matcher;
  matcher.set_objects({object_from(lesson, {middle.x, middle.y, 0})});
  for (const int covered : {0, 16}) {
    int right = 0;
    for (int k = 0; k < 8; ++k) {
      const Pose2D truth{280.3, 240.4, 0.4 * k};
      LearningImage seen = lesson;
      seen.map = bar.map.clone();
      seen.map.colRange(bar.box.br().x - covered, bar.size.width).setTo(0);
      cv::Mat image = texture({560, 480}, k + 50, 4);
      place(image, seen, middle, truth);
      add_noise(image, k + 7, 2);
      for (const auto& match : matcher.find(image).matches) {
        if (!match.graspable) continue;
        EXPECT_LT(cv::norm(match.pose.position() - truth.position()), 3) << covered << ' ' << k;
        ++right;
      }
    }
    if (covered == 0) {
      EXPECT_EQ(right, 8);
    }
  }
}

TEST(LongParts, SideBySideAreDifferentInstances) {
  const Bar bar(200, 20);
  cv::Mat map = bar.map.clone();
  map(cv::Rect(bar.box.tl(), cv::Size(30, 6))).setTo(0);
  const LearningImage lesson(3, map);
  const cv::Point2d middle = bar.middle;
  Matcher matcher;
  matcher.set_objects({object_from(lesson, {middle.x, middle.y, 0})});
  cv::Mat image = texture({680, 400}, 50, 4);
  for (int k = 0; k < 6; ++k)
    place(image, lesson, middle, {100.3 + 30 * k, 200.2, kPi / 2 + 0.02 * (k % 3)});
  add_noise(image, 1, 3);
  int graspable = 0;
  for (const auto& match : matcher.find(image).matches) graspable += match.graspable ? 1 : 0;
  EXPECT_EQ(graspable, 6);
}

TEST(LongParts, TheCentreOfSymmetryIsFoundWhereverTheReferencePointLies) {
  const Bar bar(120, 28);
  LearningImage lesson(1, bar.map);
  lesson.surface.setTo(cv::Scalar(50, 90, 160));
  lesson.surface.copyTo(lesson.image, bar.map);
  const cv::Point2d reference = cv::Point2d(bar.middle) + cv::Point2d(15, 3);
  auto model = object_from(lesson, {reference.x, reference.y, 0});
  model->symmetry = 2;
  Matcher matcher;
  matcher.set_objects({model});
  const auto found = matcher.find(lesson.image).matches;
  ASSERT_FALSE(found.empty());
  const cv::Point2d centre = found[0].pose.position() + found[0].to_symmetry_centre;
  const cv::Point2d truth = cv::Point2d(bar.middle) - cv::Point2d(0.5, 0.5);  // of even sides
  EXPECT_LT(cv::norm(centre - truth), 0.3);
}

// An object that appears .3 % larger displaces a reference point at its end.
TEST(LongParts, AReferencePointAtTheEndIsAsUncertainAsTheSize) {
  const Bar bar(400, 40);
  cv::Mat map = bar.map.clone();
  map(cv::Rect(bar.box.x, bar.middle.y - 45, 50, 40)).setTo(255);
  const LearningImage lesson(3, map);
  const cv::Point2d reference(bar.box.br().x - 10, bar.middle.y), centre = bar.middle;
  Matcher matcher;
  matcher.set_objects({object_from(lesson, {reference.x, reference.y, 0})});
  double squares = 0, stated = 0;
  for (int k = 0; k < 6; ++k) {
    const double c = 1.003 * std::cos(0.7 * k), s = 1.003 * std::sin(0.7 * k);
    const cv::Point2d at(450.3, 400.4);
    const cv::Matx23d placing(c, -s, at.x - c * centre.x + s * centre.y,  //
                              s, c, at.y - s * centre.x - c * centre.y);
    cv::Mat image = texture({900, 800}, k + 50, 4), surface, cover;
    cv::warpAffine(lesson.surface, surface, placing, image.size(), cv::INTER_LINEAR,
                   cv::BORDER_REFLECT);
    cv::warpAffine(map, cover, placing, image.size());
    surface.copyTo(image, cover > 127);
    add_noise(image, k, 3);
    const cv::Vec2d truth = placing * cv::Vec3d(reference.x, reference.y, 1);
    const auto found = matcher.find(image).matches;
    ASSERT_FALSE(found.empty());
    squares += std::pow(cv::norm(found[0].pose.position() - cv::Point2d(truth)), 2);
    stated += found[0].covariance(0, 0) + found[0].covariance(1, 1);
  }
  EXPECT_LT(std::sqrt(squares / stated), 2);
}

}  // namespace
}  // namespace mbncc::test
