// SPDX-License-Identifier: BSD-3-Clause
// The template at all rotations.
#include "matching/proposal/template_bank.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mbncc/geometry.hpp"

namespace mbncc::proposal {
namespace {

constexpr double kThickness = 10;  // [px]

TemplateBank bank_of(int length) {
  cv::Mat grey(cv::Size(length + 8, 18), CV_8UC1);
  cv::randu(grey, 0, 255);
  cv::Mat map = cv::Mat::zeros(grey.size(), CV_8UC1);
  map(cv::Rect(4, 4, length, static_cast<int>(kThickness))).setTo(255);
  return rotated_kernels(grey, map, {0.5 * (length + 7), 8.5});
}

class BarKernels : public testing::TestWithParam<int> {};

// Long bars are rotated piece by piece.
TEST_P(BarKernels, CoverTheBarAtEveryAngle) {
  const int length = GetParam();
  const TemplateBank bank = bank_of(length);
  ASSERT_TRUE(bank.searched());
  const double pixel = 1 << bank.level;
  for (const auto& kernel : *bank.kernels) {
    const double c = std::cos(kernel.angle), s = std::sin(kernel.angle);
    double low = 0, high = 0;
    for (const auto& at : kernel.pixels) {
      const double along = c * at.x + s * at.y, across = c * at.y - s * at.x;
      EXPECT_LT(std::abs(across) * pixel, kThickness / 2 + pixel);
      low = std::min(low, along);
      high = std::max(high, along);
    }
    EXPECT_NEAR(low * pixel, -length / 2., 2 * pixel) << to_degrees(kernel.angle);
    EXPECT_NEAR(high * pixel, length / 2., 2 * pixel) << to_degrees(kernel.angle);
    const double covered = static_cast<double>(kernel.pixels.size()) * pixel * pixel;
    EXPECT_GT(covered, 0.75 * length * kThickness) << to_degrees(kernel.angle);
  }
}

INSTANTIATE_TEST_SUITE_P(Lengths, BarKernels, testing::Values(120, 1000));

}  // namespace
}  // namespace mbncc::proposal
