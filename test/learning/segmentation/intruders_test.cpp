// SPDX-License-Identifier: BSD-3-Clause
// A gripper that stays in view after the grasp is not part of the object, wherever it reaches.
#include "learning/segmentation/intruders.hpp"

#include <gtest/gtest.h>

#include "learning/images.hpp"
#include "learning/things_on_platform.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/change_cut.hpp"

namespace mbncc::segmentation {
namespace {

// A lesson whose image after shows plain objects at `places`.
struct Intrusion {
  test::DrawnLesson drawn = test::draw_lesson();
  cv::Mat place = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  ObjectCut cut;

  explicit Intrusion(const std::vector<cv::Rect>& places) {
    for (const auto& part : places) place(part).setTo(255);
    cv::Mat after = drawn.platform.clone();
    after.setTo(cv::Scalar(70, 72, 75), place);
    cv::GaussianBlur(after, after, {}, 0.7);
    drawn.lesson.after = test::exposed(after, 12);
    cut = change_cut(drawn.lesson.before, drawn.lesson.after, drawn.lesson.region,
                     survey_change(drawn.lesson.before, drawn.lesson.after).changed, 2, 8);
  }
};

class Gripper : public testing::TestWithParam<std::vector<cv::Rect>> {};

TEST_P(Gripper, IsNoPartOfTheObject) {
  const Intrusion intrusion(GetParam());
  EXPECT_GT(test::iou(intrusion.cut.map, intrusion.drawn.truth), 0.88);
  const cv::Mat beside = intrusion.place & ~intrusion.drawn.truth;
  EXPECT_LT(cv::countNonZero(intrusion.cut.map & beside), 0.05 * cv::countNonZero(beside));
}

// Gripper left of the object, and on it from the left and from above, with two fingers.
INSTANTIATE_TEST_SUITE_P(Places, Gripper,
                         testing::Values(std::vector<cv::Rect>{{0, 90, 84, 20}},
                                         std::vector<cv::Rect>{{0, 90, 110, 20}},
                                         std::vector<cv::Rect>{{110, 0, 24, 95}},
                                         std::vector<cv::Rect>{{90, 0, 12, 90}, {120, 0, 12, 90}}));

TEST(Intruders, ContactWithTheObjectIsReportedToTheVerdict) {
  EXPECT_GT(Intrusion({{0, 90, 110, 20}}).cut.evidence.region_touch, 0.04);
  EXPECT_EQ(Intrusion({{0, 10, 110, 20}}).cut.evidence.region_touch, 0);
}

class FindIntruders : public testing::Test {
 protected:
  cv::Mat intruders(const std::vector<cv::Rect>& before, const std::vector<cv::Rect>& after,
                    const cv::Mat& changed, const cv::Mat& entry) const {
    likelihood::NoiseModel noise;
    for (auto& channel : noise.variance) channel.fill(8);
    return find_intruders(test::image_with(before, 11), test::image_with(after, 12), changed, entry,
                          platform_, noise);
  }

  const cv::Rect arm_{0, 50, 60, 20};
  const change::ColourMixture platform_ = change::ColourMixture::fit(
      test::image_with({}, 13), cv::Mat(test::kPlatformSize, CV_8UC1, cv::Scalar(255)));
};

TEST_F(FindIntruders, FindsArrivals) {
  const cv::Mat found =
      intruders({}, {arm_}, test::map_of({arm_}), test::map_of({cv::Rect(0, 50, 20, 20)}));
  EXPECT_GT(test::iou(found, test::map_of({arm_})), 0.95);
}

TEST_F(FindIntruders, IgnoresDepartures) {
  EXPECT_EQ(cv::countNonZero(intruders({arm_}, {}, test::map_of({arm_}),
                                       test::map_of({cv::Rect(0, 50, 20, 20)}))),
            0);
}

TEST_F(FindIntruders, IgnoresSpecks) {
  const cv::Rect speck(140, 100, 4, 4);
  const cv::Mat found = intruders({}, {arm_}, test::map_of({arm_, speck}),
                                  test::map_of({cv::Rect(0, 50, 20, 20), speck}));
  EXPECT_GT(cv::countNonZero(found), 0);
  EXPECT_EQ(cv::countNonZero(found(speck)), 0);
}

TEST_F(FindIntruders, StopsAtUnchangedPixels) {
  // An object of the arm's colour was already there before.
  const cv::Rect stays(60, 50, 40, 20);
  const cv::Mat found = intruders({stays}, {arm_, stays}, test::map_of({arm_}),
                                  test::map_of({cv::Rect(0, 50, 20, 20)}));
  EXPECT_LT(cv::countNonZero(found(stays)), 0.1 * stays.area());
}

TEST(Intruders, ComeFromBeyondTheBorder) {
  cv::Mat changed = cv::Mat::zeros(60, 80, CV_8UC1);
  changed(cv::Rect(70, 20, 10, 10)).setTo(255);
  const cv::Mat at_border = changed.clone();
  changed(cv::Rect(20, 20, 30, 30)).setTo(255);
  const cv::Mat reaching = reaching_border(changed) & changed;
  EXPECT_EQ(cv::norm(reaching, at_border, cv::NORM_INF), 0);
}

// A region that is too small cuts off the object; the part outside is not an intruder.
TEST(Intruders, AnObjectThatExceedsTheRegionIsNoIntruder) {
  test::DrawnLesson drawn = test::draw_lesson();
  drawn.lesson.region = cv::Rect(100, 60, 70, 84);
  const ObjectCut cut =
      change_cut(drawn.lesson.before, drawn.lesson.after, drawn.lesson.region,
                 survey_change(drawn.lesson.before, drawn.lesson.after).changed, 2, 8);
  cv::Mat inside = cv::Mat::zeros(drawn.truth.size(), CV_8UC1);
  drawn.truth(drawn.lesson.region).copyTo(inside(drawn.lesson.region));
  EXPECT_GT(test::iou(cut.map, inside), 0.9);
  EXPECT_GT(cut.evidence.region_touch, 0.04);
}

}  // namespace
}  // namespace mbncc::segmentation
