// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/outline_contrast.hpp"

#include <algorithm>
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

  std::shared_ptr<ObjectModel> model(const cv::Rect& more = {}) const {
    cv::Mat map = cv::Mat::zeros(220, 300, CV_8UC1);
    map(bar_) = 255;
    map(more) = 255;
    cv::circle(map, hole_, 9, cv::Scalar(0), cv::FILLED);
    auto model = std::make_shared<ObjectModel>();
    model->name = "bar";
    model->views.push_back(crop_view(scene_with(bar_), map, {145, 105, 0}));
    return model;
  }

  MissingContrast missing_in(const cv::Mat& image, const cv::Rect& more = {}) const {
    const prepared::PreparedObject object(model(more), prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const Pose2D at = compose({145, 105, 0}, inverse(view.reference_in_anchor));
    const scene::SceneLevel level(image, 0);
    templates::PoseSample sample;
    sample.read(view.fine, level, at, 0);
    return view.outline_contrast.missing(level, view.fine, sample, at, 1);
  }

  double continued_in(const cv::Mat& image) const { return missing_in(image).continued; }
  double absent_in(const cv::Mat& image) const { return missing_in(image).absent; }

  std::vector<std::string> reasons_in(const cv::Mat& image) const {
    Matcher matcher;
    matcher.set_objects({model()});
    const auto matches = matcher.find(image).matches;
    return matches.empty() ? std::vector<std::string>{"not found"} : matches.front().reasons;
  }

  bool is_graspable_in(const cv::Mat& image) const { return reasons_in(image).empty(); }
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

// Half a turn of a bar with a faint mark competes, but only the best pose is examined.
TEST_F(OutlineContrastTest, TheExaminedPoseOfAPlaceIsReported) {
  const auto scene_of = [&](int width) {
    cv::Mat image(220, 300, CV_8UC3, kTable);
    image(cv::Rect(bar_.x, bar_.y, width, bar_.height)) = kPart;
    cv::circle(image, {165, 105}, 4, kPart + cv::Scalar(20, 20, 20), cv::FILLED, cv::LINE_AA);
    cv::GaussianBlur(image, image, {}, 0.8);
    return image;
  };
  cv::Mat map = cv::Mat::zeros(220, 300, CV_8UC1);
  map(bar_) = 255;
  auto bar = std::make_shared<ObjectModel>();
  bar->name = "bar";
  bar->views.push_back(crop_view(scene_of(bar_.width), map, {145, 105, 0}));
  SearchConfig config;
  config.min_score = 1e-6;
  Matcher matcher(config);
  matcher.set_objects({bar});
  const auto matches = matcher.find(scene_of(bar_.width + 20)).matches;
  ASSERT_FALSE(matches.empty());
  const auto& reasons = matches.front().reasons;
  EXPECT_EQ(std::count(reasons.begin(), reasons.end(), "too unlikely to be examined"), 0);
  EXPECT_EQ(std::count(reasons.begin(), reasons.end(), "part of something larger"), 1);
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

TEST_F(OutlineContrastTest, AShorterObjectLacksAPart) {
  const cv::Mat shorter = scene_with({bar_.tl(), cv::Size(bar_.width - 30, bar_.height)});
  for (const double light : {1.0, 0.4}) {
    EXPECT_GT(absent_in(shorter * light), 0.5) << light;
    EXPECT_EQ(absent_in(scene_with(bar_) * light), 0) << light;
  }
  const auto reasons = reasons_in(shorter);
  EXPECT_EQ(std::count(reasons.begin(), reasons.end(), "a part is absent"), 1);
}

TEST_F(OutlineContrastTest, ACoveredPartIsNotAbsent) {
  for (const cv::Scalar& cover : {cv::Scalar(120, 170, 90), cv::Scalar(110, 130, 160)})
    for (const double light : {1.0, 0.4}) {
      cv::Mat covered = scene_with(bar_);
      covered(cv::Rect(150, 60, 70, 90)) = cover;
      EXPECT_EQ(absent_in(covered * light), 0) << cover << ' ' << light;
    }
}

TEST_F(OutlineContrastTest, TableInTheMapIsNotAbsent) {
  const cv::Rect table(bar_.br().x, bar_.y, 30, bar_.height);
  EXPECT_EQ(missing_in(scene_with(bar_), table).absent, 0);
}

// Without its handle, the object looks the same after half a turn.
TEST_F(OutlineContrastTest, AHandleThatLiesOverTheBackgroundForbidsAGrasp) {
  const auto frame_at = [](double angle) {
    cv::Mat image(240, 260, CV_8UC3, kTable), drawn;
    cv::rectangle(image, {90, 90, 70, 60}, kPart, 12);
    cv::rectangle(image, {118, 155, 14, 40}, kPart, cv::FILLED);
    cv::warpAffine(image, drawn, cv::getRotationMatrix2D({125, 120}, angle, 1), image.size(),
                   cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    return drawn;
  };
  const cv::Mat lesson = frame_at(0);
  cv::Mat map;
  cv::inRange(lesson, kPart, kPart, map);
  auto model = std::make_shared<ObjectModel>();
  model->name = "frame";
  model->views.push_back(crop_view(lesson, map, {125, 120, 0}));
  const prepared::PreparedObject object(model, prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const scene::SceneLevel level(frame_at(180), 0);
  const auto absent_at = [&](double angle) {
    const Pose2D at = compose({125, 120, angle}, inverse(view.reference_in_anchor));
    templates::PoseSample sample;
    sample.read(view.fine, level, at, 0);
    return view.outline_contrast.missing(level, view.fine, sample, at, 1).absent;
  };
  EXPECT_GT(absent_at(0), 0.4);
  EXPECT_LT(absent_at(kPi), 0.1);
}

}  // namespace
}  // namespace mbncc::evidence
