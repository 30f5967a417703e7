// SPDX-License-Identifier: BSD-3-Clause
// Pixels that saturate the camera show nothing of the object and are not compared.
#include <gtest/gtest.h>

#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::templates {
namespace {

const cv::Rect kSpot(40, 70, 30, 14);  // [px] a seventh of the object

class HighlightsTest : public ::testing::Test {
 protected:
  const test::LearningImage source_{1};

  /// Fraction of the surface points learned from `learned` that are compared in `image`.
  static double compared(const cv::Mat& learned, const cv::Mat& image) {
    auto model = std::make_shared<ObjectModel>();
    model->name = "object";
    model->views.push_back(crop_view(learned, test::angle_map(), {58, 60, 0}));
    const prepared::PreparedObject object(model, prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const scene::SceneLevel scene(image, 0);
    SurfaceSample sample;
    const Pose2D anchor = compose({58, 60, 0}, inverse(view.reference_in_anchor));
    view.fine.surface.sample(scene.whole(), anchor, sample);
    return static_cast<double>(sample.visible) / static_cast<double>(sample.points);
  }

  static cv::Mat with_spot(const cv::Mat& image) {
    cv::Mat glossy = image.clone();
    glossy(kSpot) = cv::Scalar::all(255);
    return glossy;
  }
};

TEST_F(HighlightsTest, AreNotCompared) {
  EXPECT_EQ(compared(source_.image, source_.image), 1);
  const double left = compared(source_.image, with_spot(source_.image));
  EXPECT_LT(left, 0.95);
  EXPECT_GT(left, 0.7);
}

TEST_F(HighlightsTest, LearnedWhiteIsNoHighlight) {
  const cv::Mat white = with_spot(source_.image);
  EXPECT_EQ(compared(white, white), 1);
}

TEST_F(HighlightsTest, SaturationByBrighterLightIsNoHighlight) {
  cv::Mat pale = source_.image.clone(), brighter;
  pale(kSpot) = cv::Scalar::all(180);
  pale.convertTo(brighter, -1, 1.5);
  EXPECT_GT(compared(pale, brighter), 0.97);
}

TEST_F(HighlightsTest, MostlySaturatedImagesAreComparedCompletely) {
  cv::Mat white(source_.image.size(), CV_8UC3, cv::Scalar::all(255));
  EXPECT_EQ(compared(source_.image, white), 1) << "what a white table shows speaks against it";
}

TEST_F(HighlightsTest, DoNotPreventAGrasp) {
  Matcher matcher;
  matcher.set_objects({test::object_from(source_, {58, 60, 0})});
  const cv::Mat background = test::texture({320, 240}, 77, 5);
  cv::Mat scene = background.clone();
  with_spot(source_.surface).copyTo(scene(cv::Rect({90, 60}, source_.map.size())), source_.map);
  const auto matches = matcher.find(scene).matches;
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_TRUE(matches.front().graspable);
  EXPECT_LT(cv::norm(matches.front().pose.position() - cv::Point2d(148, 120)), 0.5);
}

}  // namespace
}  // namespace mbncc::templates
