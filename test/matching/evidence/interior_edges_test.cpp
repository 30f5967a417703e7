// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/interior_edges.hpp"

#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::evidence {
namespace {

using Dots = std::vector<cv::Point>;

const Dots kTaught{{44, 50}, {72, 70}, {44, 70}};

/// A white tile of 64 x 44 px with black dots, in the middle of 120 x 120 pixels.
test::LearningImage tile(const Dots& dots) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(28, 38, 64, 44)) = 255;
  test::LearningImage image(3, map);
  image.surface.setTo(cv::Scalar(215, 220, 218));
  for (const auto& dot : dots)
    cv::circle(image.surface, dot, 6, cv::Scalar(25, 22, 20), cv::FILLED, cv::LINE_AA);
  cv::GaussianBlur(image.surface, image.surface, {}, 0.7);
  image.surface.copyTo(image.image, map);
  return image;
}

class InteriorEdgesTest : public test::MatcherTest {
 protected:
  const Pose2D truth_{170, 120, 0.8};

  cv::Mat scene_with(const test::LearningImage& seen) const {
    cv::Mat scene = test::texture({320, 240}, 77, 5);
    test::place(scene, seen, {60, 60}, truth_);
    return scene;
  }

  /// Of the taught tile and `scene` at its true pose.
  double difference(const cv::Mat& scene, const Dots& taught = kTaught, double scale = 1) const {
    const prepared::PreparedObject object(test::object_from(tile(taught), {60, 60, 0}),
                                          prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    return view.interior_edges.difference(
        scene::SceneLevel(scene, 0), compose(truth_, inverse(view.reference_in_anchor)), scale);
  }
};

TEST_F(InteriorEdgesTest, TheSamePrintDiffersLittle) {
  const cv::Mat scene = scene_with(tile(kTaught));
  EXPECT_LT(difference(scene), 0.3);
  EXPECT_LT(difference(scene * 0.4), 0.3) << "in less light";
  cv::Mat noise(scene.size(), CV_16SC3), noisy;
  cv::RNG random(5);
  random.fill(noise, cv::RNG::NORMAL, 0, 6);
  cv::add(scene, noise, noisy, {}, CV_8U);
  EXPECT_LT(difference(noisy), 0.3);
}

// Each is one dot more or less, of one to nine.
TEST_F(InteriorEdgesTest, OneDotMoreOrLessIsAnotherPrint) {
  Dots dots{{60, 60}};
  for (const cv::Point dot :
       {cv::Point(42, 48), {60, 48}, {78, 48}, {42, 60}, {78, 60}, {42, 72}, {60, 72}, {78, 72}}) {
    const Dots fewer = dots;
    dots.push_back(dot);
    EXPECT_GT(difference(scene_with(tile(dots)), fewer), 1.3) << dots.size();
    EXPECT_GT(difference(scene_with(tile(fewer)), dots), 1.3) << dots.size();
  }
}

// A white tile may saturate as a whole, or its lighter part alone, which is no highlight.
TEST_F(InteriorEdgesTest, DotsOnASaturatedPartAreCompared) {
  Dots more = kTaught;
  more.emplace_back(41, 60);
  for (const double darker : {1.0, 0.6}) {
    const auto seen = [&](const Dots& dots) {
      test::LearningImage image = tile(dots);
      cv::Mat right = image.surface.colRange(56, 120);
      right *= darker;
      image.surface.copyTo(image.image, image.map);
      return image;
    };
    const prepared::PreparedObject object(test::object_from(seen(kTaught), {60, 60, 0}),
                                          prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const auto difference_to = [&](const Dots& dots) {
      const cv::Mat scene = scene_with(seen(dots)) * 1.3;
      return view.interior_edges.difference(scene::SceneLevel(scene, 0),
                                            compose(truth_, inverse(view.reference_in_anchor)), 1);
    };
    EXPECT_GT(difference_to(more), 1.3) << darker;
    EXPECT_LT(difference_to(kTaught), 0.3) << darker;
  }
}

TEST_F(InteriorEdgesTest, PlainObjectsDoNotDiffer) {
  EXPECT_EQ(difference(scene_with(tile({})), {}), 0);
}

TEST_F(InteriorEdgesTest, AnotherSizeIsComparedAtThatSize) {
  cv::Mat larger;
  const cv::Mat about =
      (cv::Mat_<double>(2, 3) << 1.25, 0, -0.25 * truth_.x, 0, 1.25, -0.25 * truth_.y);
  cv::warpAffine(scene_with(tile(kTaught)), larger, about, {320, 240});
  EXPECT_LT(difference(larger, kTaught, 1.25), 0.3);
  EXPECT_GT(difference(larger), 0.5);
}

TEST_F(InteriorEdgesTest, ATileWithOtherDotsIsNotGraspable) {
  const Matcher matcher = matcher_of({test::object_from(tile(kTaught), {60, 60, 0})});
  const auto own = matcher.find(scene_with(tile(kTaught))).matches;
  ASSERT_EQ(own.size(), 1U);
  EXPECT_TRUE(own.front().graspable) << own.front().reasons.front();
  Dots four = kTaught;
  four.emplace_back(76, 48);
  const auto others = matcher.find(scene_with(tile(four))).matches;
  ASSERT_FALSE(others.empty());
  EXPECT_FALSE(others.front().graspable);
  EXPECT_EQ(others.front().reasons.front(), "edges inside the outline differ");
}

}  // namespace
}  // namespace mbncc::evidence
