// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/outline_contrast.hpp"

#include <opencv2/imgproc.hpp>

#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::evidence {
namespace {

const cv::Scalar kTable(225, 225, 230), kPart(60, 80, 110), kMark(40, 160, 200);

/// A bar with a mark and a hole, on a plain table.
class OutlineContrastTest : public ::testing::Test {
 protected:
  const cv::Rect bar_{100, 90, 90, 30};
  const cv::Point hole_{118, 105};

  cv::Mat scene_with(const cv::Rect& bar, bool hole = true, const cv::Rect& more = {}) const {
    cv::Mat image(220, 300, CV_8UC3, kTable);
    image(bar) = kPart;
    image(more) = kPart;
    if (hole) cv::circle(image, hole_, 9, kTable, cv::FILLED, cv::LINE_AA);
    cv::circle(image, {165, 105}, 7, kMark, cv::FILLED, cv::LINE_AA);
    cv::GaussianBlur(image, image, {}, 0.8);
    return image;
  }

  std::shared_ptr<ObjectModel> model() const {
    cv::Mat map = cv::Mat::zeros(220, 300, CV_8UC1);
    map(bar_) = 255;
    cv::circle(map, hole_, 9, cv::Scalar(0), cv::FILLED);
    auto model = std::make_shared<ObjectModel>();
    model->name = "bar";
    model->views.push_back(crop_view(scene_with(bar_), map, {145, 105, 0}));
    return model;
  }

  double continued_in(const cv::Mat& image) const {
    const prepared::PreparedObject object(model(), prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const Pose2D at = compose({145, 105, 0}, inverse(view.reference_in_anchor));
    const scene::SceneLevel level(image, 0);
    templates::PoseSample sample;
    sample.read(view.fine, level, at, 0);
    return view.outline_contrast.longest_continued(level, view.fine, sample, at, 1);
  }

  bool is_graspable_in(const cv::Mat& image) const {
    Matcher matcher;
    matcher.set_objects({model()});
    const auto matches = matcher.find(image).matches;
    return !matches.empty() && matches.front().graspable;
  }
};

TEST_F(OutlineContrastTest, TheObjectAloneDoesNotGoOnInAnyLight) {
  const cv::Mat image = scene_with(bar_);
  for (const double light : {1.0, 0.4}) EXPECT_EQ(continued_in(image * light), 0) << light;
  EXPECT_TRUE(is_graspable_in(image));
}

TEST_F(OutlineContrastTest, APartOfSomethingLargerGoesOn) {
  const cv::Mat longer = scene_with({bar_.tl(), cv::Size(180, bar_.height)});
  for (const double light : {1.0, 0.4})
    EXPECT_NEAR(continued_in(longer * light), bar_.height / std::sqrt(bar_.area()), 0.15) << light;
  EXPECT_FALSE(is_graspable_in(longer));
}

TEST_F(OutlineContrastTest, ItGoesOnWhereverTheOutlineStarts) {
  for (const cv::Rect& handle :
       {cv::Rect(bar_.x + 30, 20, 30, 80), cv::Rect(bar_.x + 30, 110, 30, 80),
        cv::Rect(bar_.x, 20, 30, 80), cv::Rect(bar_.x + 60, 20, 30, 80)}) {
    EXPECT_GT(continued_in(scene_with(bar_, true, handle)), 0.35) << handle;
  }
}

TEST_F(OutlineContrastTest, AMissingHoleGoesOn) {
  EXPECT_NEAR(continued_in(scene_with(bar_, false)), 2 * kPi * 9 / std::sqrt(bar_.area()), 0.2);
  EXPECT_FALSE(is_graspable_in(scene_with(bar_, false)));
}

TEST_F(OutlineContrastTest, ACoverIsNothingLarger) {
  for (const cv::Scalar& cover : {cv::Scalar(120, 170, 90), cv::Scalar(110, 130, 160)})
    for (const double light : {1.0, 0.4}) {
      cv::Mat covered = scene_with(bar_);
      covered(cv::Rect(160, 60, 60, 90)) = cover;
      EXPECT_EQ(continued_in(covered * light), 0) << cover << ' ' << light;
    }
}

TEST_F(OutlineContrastTest, TheBorderOfTheImageIsNoContinuation) {
  const cv::Mat cut = scene_with(bar_).colRange(0, bar_.br().x + 2).clone();
  EXPECT_EQ(continued_in(cut), 0);
}

TEST_F(OutlineContrastTest, AShortContactIsNothingLarger) {
  cv::Mat touching = scene_with(bar_);
  cv::circle(touching, {bar_.br().x + 3, 105}, 4, kPart, cv::FILLED, cv::LINE_AA);
  EXPECT_GT(continued_in(touching), 0);
  EXPECT_LT(continued_in(touching), 0.2);
}

}  // namespace
}  // namespace mbncc::evidence
