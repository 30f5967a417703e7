// SPDX-License-Identifier: BSD-3-Clause
#include "learning/alignment/phase_shift.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "learning/alignment/image_shift.hpp"

namespace mbncc::alignment {
namespace {

cv::Mat ground(const cv::Size& size) {
  cv::Mat texture(size, CV_32FC1);
  cv::RNG(5).fill(texture, cv::RNG::UNIFORM, 0, 255);
  cv::GaussianBlur(texture, texture, {}, 1.5);
  return texture;
}

cv::Mat noisy(const cv::Mat& image, int seed) {
  cv::Mat noise(image.size(), CV_32FC1);
  cv::RNG(seed).fill(noise, cv::RNG::NORMAL, 0, 2);
  return image + noise;
}

TEST(PhaseShift, IsZeroForImagesOfOneOrTwoRows) {
  for (const int rows : {1, 2}) {
    const cv::Mat strip = ground({200, rows});
    EXPECT_EQ(phase_shift(strip, strip), cv::Point2d());
  }
}

// Tests even and odd sizes whose transform is fast, and others.
TEST(PhaseShift, EqualsThatOfOpenCv) {
  for (const cv::Size size : {cv::Size(320, 240), cv::Size(225, 135), cv::Size(157, 211)}) {
    const cv::Mat wide = ground(size + cv::Size(20, 20));
    const cv::Mat before = noisy(wide(cv::Rect({10, 10}, size)), 1);
    const cv::Mat after = noisy(wide(cv::Rect({3, 14}, size)), 2);
    const cv::Point2d shift = phase_shift(before, after);
    EXPECT_NEAR(shift.x, 7, 0.5) << size;
    EXPECT_NEAR(shift.y, -4, 0.5) << size;
    if (size.width % 2 != 0) continue;  // cv::phaseCorrelate() is half a pixel off for these
    cv::Mat window;
    cv::createHanningWindow(window, size, CV_32F);
    EXPECT_LT(cv::norm(shift - cv::phaseCorrelate(before.clone(), after.clone(), window)), 1e-3);
  }
}

TEST(PhaseShift, CanBeUndone) {
  const cv::Mat before = ground({160, 120});
  const cv::Mat after = undo_shift(before, {-2.25, 1.5});
  const cv::Point2d shift = phase_shift(before, after);
  EXPECT_NEAR(shift.x, 2.25, 0.4);
  EXPECT_NEAR(shift.y, -1.5, 0.4);
  const cv::Rect inner(20, 20, 120, 80);
  EXPECT_LT(cv::norm(before(inner), undo_shift(after, shift)(inner), cv::NORM_L1),
            0.3 * cv::norm(before(inner), after(inner), cv::NORM_L1));
}

TEST(PhaseShift, IsZeroForTheSameImage) {
  const cv::Mat image = ground({160, 120});
  EXPECT_LT(cv::norm(phase_shift(image, noisy(image, 3))), 0.05);
  EXPECT_EQ(phase_shift(cv::Mat::zeros(image.size(), CV_32FC1), image), cv::Point2d());
}

}  // namespace
}  // namespace mbncc::alignment
