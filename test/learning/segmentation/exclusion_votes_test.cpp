// SPDX-License-Identifier: BSD-3-Clause
// Votes of excluding strokes: which other pixels of a map are removed as well.
#include "learning/segmentation/exclusion_votes.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"

namespace mbncc::segmentation {
namespace {

constexpr int kSide = 60;
const cv::Rect kShaded(15, 20, 15, 20), kRed(30, 20, 15, 20), kStroke(20, 24, 3, 3);

cv::Mat mask_of(const cv::Rect& area) {
  cv::Mat mask = cv::Mat::zeros(kSide, kSide, CV_8UC1);
  if (!area.empty()) mask(area).setTo(255);
  return mask;
}

// Half of the map is the platform in a deep shadow, which is less certain than the other, red half.
CutImages drawn_cut() {
  CutImages cut;
  const cv::Size size(kSide, kSide);
  cut.after = test::texture(size, cv::Scalar(60, 130, 60), 4, 1);
  cut.before = cut.after.clone();
  cut.before(kShaded) *= 0.3;
  test::texture(kRed.size(), cv::Scalar(40, 40, 170), 4, 3).copyTo(cut.before(kRed));
  cut.map = mask_of(kShaded | kRed);
  cut.unary = cv::Mat(size, CV_32FC1, cv::Scalar(-5));
  cut.unary(kShaded).setTo(2);
  cut.unary(kRed).setTo(5);
  return cut;
}

// Mean over the interior of an area.
double mean_on(const cv::Mat& votes, const cv::Rect& area) {
  return cv::mean(votes(cv::Rect(area.tl() + cv::Point(3, 3), area.br() - cv::Point(3, 3))))[0];
}

TEST(ExclusionVotes, ExcludePixelsThatLookLikeTheStroke) {
  const cv::Mat votes = exclusion_votes(drawn_cut(), mask_of(kStroke));
  EXPECT_GT(mean_on(votes, kShaded), 3);
  EXPECT_LT(mean_on(votes, kRed), -3);
}

TEST(ExclusionVotes, WorkWithASingleDot) {
  const cv::Mat votes = exclusion_votes(drawn_cut(), mask_of({20, 24, 1, 1}));
  EXPECT_GT(mean_on(votes, kShaded), 3);
  EXPECT_LT(mean_on(votes, kRed), -3);
}

// An ambiguous appearance: a grey between those of the stroke and the object.
TEST(ExclusionVotes, ExcludeOutermostPixelsMoreReadily) {
  CutImages cut = drawn_cut();
  const cv::Rect grey(10, 32, 20, 8);  // beyond the map's edge at 15 as well
  test::texture(grey.size(), cv::Scalar(30, 45, 100), 4, 5).copyTo(cut.before(grey));
  const cv::Mat votes = exclusion_votes(cut, mask_of(kStroke));
  const double outermost = cv::mean(votes(cv::Rect(15, 34, 1, 4)))[0];
  const double inside = cv::mean(votes(cv::Rect(17, 34, 3, 4)))[0];
  EXPECT_GT(outermost, inside + 1);
}

TEST(ExclusionVotes, AreLimitedToTheMap) {
  const CutImages cut = drawn_cut();
  const cv::Mat votes = exclusion_votes(cut, mask_of(kStroke));
  EXPECT_EQ(cv::norm(votes, cv::NORM_INF, ~cut.map), 0);
  EXPECT_LE(cv::norm(votes, cv::NORM_INF), 10);
}

TEST(ExclusionVotes, AreZeroWithoutAStrokeOrAnyRemainingMap) {
  const CutImages cut = drawn_cut();
  EXPECT_EQ(cv::norm(exclusion_votes(cut, mask_of({})), cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(exclusion_votes(cut, cut.map), cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(exclusion_votes(cut, mask_of({0, 0, kSide, kSide})), cv::NORM_INF), 0);
}

}  // namespace
}  // namespace mbncc::segmentation
