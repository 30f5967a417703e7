// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/print_comparison.hpp"

#include <algorithm>
#include <optional>

#include "matching/evidence/tool_fixture.hpp"
#include "matching/matcher_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::evidence {
namespace {

using Dots = std::vector<cv::Point>;

const Dots kTaught{{44, 50}, {72, 70}, {44, 70}};

/// A white tile of 64 x 44 px with black dots, in the centre of 120 x 120 pixels.
test::LearningImage tile(const Dots& dots, const cv::Scalar& body = {215, 220, 218},
                         const cv::Scalar& dark = {25, 22, 20}) {
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(28, 38, 64, 44)) = 255;
  test::LearningImage image(3, map);
  image.surface.setTo(body);
  for (const auto& dot : dots) cv::circle(image.surface, dot, 6, dark, cv::FILLED, cv::LINE_AA);
  cv::GaussianBlur(image.surface, image.surface, {}, 0.7);
  image.surface.copyTo(image.image, map);
  return image;
}

/// Difference of `view` in `scene` with its anchor at `pose`.
PrintDifference print_at(const prepared::PreparedView& view, const cv::Mat& scene,
                         const Pose2D& pose, double scale = 1) {
  const scene::SceneLevel level(scene, 0);
  templates::PoseSample sample;
  sample.read(view.fine, level, pose, 0, scale);
  return view.print.difference(level, view.fine, sample, pose, scale);
}

class PrintTest : public test::MatcherTest {
 protected:
  const Pose2D truth_{170, 120, 0.8};

  cv::Mat scene_with(const test::LearningImage& seen) const {
    cv::Mat scene = test::texture({320, 240}, 77, 5);
    test::place(scene, seen, {60, 60}, truth_);
    return scene;
  }

  /// Difference between the taught tile and `scene` at its true pose.
  PrintDifference differences(const cv::Mat& scene, const Dots& taught = kTaught,
                              double scale = 1) const {
    const prepared::PreparedObject object(test::object_from(tile(taught), {60, 60, 0}),
                                          prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    return print_at(view, scene, compose(truth_, inverse(view.reference_in_anchor)), scale);
  }

  double difference(const cv::Mat& scene, const Dots& taught = kTaught, double scale = 1) const {
    return differences(scene, taught, scale).largest;
  }

  /// The best match of the taught tile, whatever its score; nullopt if there is none.
  static std::optional<Match> best_match(const cv::Mat& scene) {
    SearchConfig config;
    config.min_score = 1e-6;
    Matcher matcher(config);
    matcher.set_objects({test::object_from(tile(kTaught), {60, 60, 0})});
    const auto matches = matcher.find(scene).matches;
    if (matches.empty()) return {};
    return matches.front();
  }
};

TEST_F(PrintTest, TheSamePrintDiffersLittle) {
  const cv::Mat scene = scene_with(tile(kTaught));
  EXPECT_LT(difference(scene), 0.15);
  EXPECT_LT(difference(scene * 0.4), 0.15) << "in less light";
  cv::Mat noise(scene.size(), CV_16SC3), noisy;
  cv::RNG random(5);
  random.fill(noise, cv::RNG::NORMAL, 0, 6);
  cv::add(scene, noise, noisy, {}, CV_8U);
  EXPECT_LT(difference(noisy), 0.15);
}

// Each variant has one dot more or less, out of one to nine.
TEST_F(PrintTest, OneDotMoreOrLessIsAnotherPrint) {
  Dots dots{{60, 60}};
  for (const cv::Point dot :
       {cv::Point(42, 48), {60, 48}, {78, 48}, {42, 60}, {78, 60}, {42, 72}, {60, 72}, {78, 72}}) {
    const Dots fewer = dots;
    dots.push_back(dot);
    EXPECT_GT(difference(scene_with(tile(dots)), fewer), 1.3) << dots.size();
    EXPECT_GT(difference(scene_with(tile(fewer)), dots), 1.3) << dots.size();
  }
}

// A white tile may saturate completely, or only in its lighter part, which is not a highlight.
TEST_F(PrintTest, DotsOnASaturatedPartAreCompared) {
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
      const Pose2D pose = compose(truth_, inverse(view.reference_in_anchor));
      return print_at(view, scene, pose).largest;
    };
    EXPECT_GT(difference_to(more), 0.9) << darker;
    EXPECT_LT(difference_to(kTaught), 0.15) << darker;
  }
}

// Whatever is seen at the missing dot saturates like what surrounds it.
TEST_F(PrintTest, ADotMissesOnASaturatedTile) {
  Dots more = kTaught;
  more.emplace_back(58, 60);
  const cv::Mat scene = scene_with(tile(kTaught)) * 1.3;
  EXPECT_GT(difference(scene, more), 0.9);
  EXPECT_LT(difference(scene, kTaught), 0.15);
}

TEST_F(PrintTest, PlainObjectsDoNotDiffer) {
  EXPECT_EQ(difference(scene_with(tile({})), {}), 0);
}

TEST_F(PrintTest, AnotherSizeIsComparedAtThatSize) {
  cv::Mat larger;
  const cv::Mat about =
      (cv::Mat_<double>(2, 3) << 1.25, 0, -0.25 * truth_.x, 0, 1.25, -0.25 * truth_.y);
  cv::warpAffine(scene_with(tile(kTaught)), larger, about, {320, 240});
  EXPECT_LT(difference(larger, kTaught, 1.25), 0.15);
  Dots four = kTaught;
  four.emplace_back(58, 60);
  EXPECT_GT(difference(larger, four, 1.25), 1.3);
}

TEST_F(PrintTest, AThingAcrossTheContourIsNoPrint) {
  cv::Mat scene = scene_with(tile(kTaught));
  cv::line(scene, {212, 77}, {126, 160}, {30, 60, 140}, 5, cv::LINE_AA);
  EXPECT_GT(differences(scene).largest, 1.3);
  EXPECT_LT(differences(scene).enclosed, 0.15);
  Dots four = kTaught;
  four.emplace_back(58, 60);
  EXPECT_GT(differences(scene_with(tile(four))).enclosed, 1.3) << "a dot more";
  EXPECT_GT(differences(scene_with(tile(kTaught)), four).enclosed, 1.3) << "a dot less";
}

TEST_F(PrintTest, ADotUnderACoverIsNoPrint) {
  const Dots corner{{46, 56}, {76, 64}};
  cv::Mat scene = scene_with(tile(corner));
  const cv::Point2d at = transform(truth_, cv::Point2d(34, 56) - cv::Point2d(60, 60));
  cv::circle(scene, at, 24, {60, 110, 190}, cv::FILLED, cv::LINE_AA);
  EXPECT_LT(differences(scene, corner).largest, 0.15);
  EXPECT_GT(differences(scene_with(tile({corner[1]})), corner).enclosed, 0.8) << "not covered";
}

TEST_F(PrintTest, BeyondTheImageNothingDiffers) {
  const cv::Mat scene = scene_with(tile(kTaught));
  const auto right = static_cast<int>(truth_.x);
  EXPECT_LT(difference(scene.colRange(0, right).clone()), 0.15) << "half of it";
  cv::Mat far(scene.size(), scene.type(), cv::Scalar::all(90));
  EXPECT_EQ(difference(far.colRange(0, 60).clone()), 0) << "none of it";
}

TEST_F(PrintTest, ATileWithOtherDotsHasALowerScoreAndIsNotGraspable) {
  const auto own = best_match(scene_with(tile(kTaught)));
  ASSERT_TRUE(own);
  EXPECT_TRUE(own->graspable) << own->reasons.front();
  EXPECT_EQ(own->odds.print, 0);
  Dots four = kTaught;
  four.emplace_back(58, 60);
  const auto other = best_match(scene_with(tile(four)));
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->graspable);
  EXPECT_GT(other->odds.print, 3);
  EXPECT_LT(other->score, own->score);
  EXPECT_NEAR(other->odds.of_pose(),
              other->odds.evidence - other->odds.colour - other->odds.mirror - other->odds.print,
              1e-9);
  EXPECT_EQ(
      std::count(other->reasons.begin(), other->reasons.end(), "print inside the outline differs"),
      1);
}

/// A tile with a thin outlined triangle.
test::LearningImage with_triangle(const cv::Scalar& line, const cv::Point& tip = {80, 52}) {
  test::LearningImage image = tile({});
  const std::vector<cv::Point> triangle{{38, 46}, tip, {50, 76}};
  cv::polylines(image.surface, triangle, true, line, 2, cv::LINE_AA);
  cv::GaussianBlur(image.surface, image.surface, {}, 0.7);
  image.surface.copyTo(image.image, image.map);
  return image;
}

class FinePrintTest : public PrintTest {
 protected:
  const cv::Scalar red_{60, 50, 200}, purple_{150, 60, 110};

  FinePrintTest() { model_ = test::object_from(with_triangle(red_), {60, 60, 0}); }

  double difference_in_detail(const cv::Mat& scene) const {
    const prepared::PreparedObject object(model_, prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const scene::SceneLevel level(scene, 0);
    const Pose2D pose = compose(truth_, inverse(view.reference_in_anchor));
    templates::PoseSample sample;
    sample.read(view.fine, level, pose, 0);
    return view.print.difference_in_detail(level, view.fine, sample, pose, 1);
  }

  bool is_graspable_in(const cv::Mat& scene) const {
    Matcher matcher;
    matcher.set_objects({model_});
    const auto matches = matcher.find(scene).matches;
    return !matches.empty() && matches.front().graspable;
  }

  std::shared_ptr<ObjectModel> model_;
};

TEST_F(FinePrintTest, ThinLinesOfAnotherColourOrShapeDiffer) {
  EXPECT_LT(difference_in_detail(scene_with(with_triangle(red_))), 0.2);
  EXPECT_GT(difference_in_detail(scene_with(with_triangle(purple_))), 1.6);
  EXPECT_GT(difference_in_detail(scene_with(with_triangle(red_, {64, 70}))), 1.6);
  EXPECT_GT(difference_in_detail(scene_with(tile({}))), 1.6) << "no print";
}

TEST_F(FinePrintTest, OnlyTheTaughtOneIsGraspable) {
  EXPECT_TRUE(is_graspable_in(scene_with(with_triangle(red_))));
  EXPECT_FALSE(is_graspable_in(scene_with(with_triangle(purple_))));
  EXPECT_FALSE(is_graspable_in(scene_with(with_triangle(red_, {64, 70}))));
}

TEST_F(FinePrintTest, GradualLightIsNoDetail) {
  cv::Mat scene = scene_with(with_triangle(red_)), light(scene.size(), CV_32FC3);
  for (int x = 0; x < light.cols; ++x)
    light.col(x).setTo(cv::Scalar(0.7 + 0.005 * (x - 170), 0.75, 0.8 - 0.005 * (x - 170)));
  scene.convertTo(scene, CV_32F);
  scene = scene.mul(light);
  scene.convertTo(scene, CV_8U);
  EXPECT_LT(difference_in_detail(scene), 0.4);
}

/// A grey tile with a mark and filled discs of this radius.
test::LearningImage with_discs(const Dots& dots, int radius, double grey) {
  test::LearningImage image = tile({}, cv::Scalar::all(200));
  cv::circle(image.surface, {84, 44}, 3, {40, 40, 190}, cv::FILLED, cv::LINE_AA);
  for (const auto& dot : dots)
    cv::circle(image.surface, dot, radius, cv::Scalar::all(grey), cv::FILLED, cv::LINE_AA);
  cv::GaussianBlur(image.surface, image.surface, {}, 0.7);
  image.surface.copyTo(image.image, image.map);
  return image;
}

// The brightness differs by less than shading may cause; only the edges tell.
TEST_F(PrintTest, ATileWithOtherFaintDiscsIsNotGraspable) {
  struct Prints {
    Dots taught, other;
    int radius;
  };
  const Prints kPrints[] = {{{{44, 52}}, {{44, 52}, {62, 62}}, 6},
                            {{{44, 52}, {62, 62}}, {{44, 52}}, 6},
                            {{{52, 60}}, {}, 12},
                            {{}, {{52, 60}}, 12}};
  for (const Prints& prints : kPrints)
    for (const double grey : {110., 130., 150.}) {
      Matcher matcher;
      matcher.set_objects(
          {test::object_from(with_discs(prints.taught, prints.radius, grey), {60, 60, 0})});
      const auto is_graspable = [&](const Dots& dots) {
        const auto seen = scene_with(with_discs(dots, prints.radius, grey));
        const auto matches = matcher.find(seen).matches;
        return !matches.empty() && matches.front().graspable;
      };
      EXPECT_TRUE(is_graspable(prints.taught)) << prints.radius << ' ' << grey;
      EXPECT_FALSE(is_graspable(prints.other)) << prints.radius << ' ' << grey;
    }
}

TEST_F(PrintTest, EdgesAreComparedAtTheRotationOfThePose) {
  const auto striped = [] {
    test::LearningImage image = tile({});
    cv::line(image.surface, {40, 50}, {80, 68}, {110, 110, 110}, 5);
    cv::GaussianBlur(image.surface, image.surface, {}, 0.7);
    image.surface.copyTo(image.image, image.map);
    return image;
  }();
  const prepared::PreparedObject object(test::object_from(striped, {60, 60, 0}),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  const scene::SceneLevel level(scene_with(striped), 0);
  const Pose2D pose = compose(truth_, inverse(view.reference_in_anchor));
  templates::PoseSample sample;
  sample.read(view.fine, level, pose, 0);
  EXPECT_LT(view.interior_edges.difference(level, view.fine.contour, sample.contour, pose, 1), 0.3);
}

class PrintOfATool : public test::ToolTest {
 protected:
  PrintDifference difference_in(const cv::Mat& image) const {
    const prepared::PreparedObject object(tool(), prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const Pose2D at = compose({150, 72, 0}, inverse(view.reference_in_anchor));
    return print_at(view, image, at);
  }
};

TEST_F(PrintOfATool, TheObjectItselfDiffersLittleInAnyLight) {
  EXPECT_LT(difference_in(image_with(test::kRed, 2)).largest, 0.1);
  for (const auto& [factor, offset] :
       {std::pair(0.6, 40), std::pair(0.8, -10), std::pair(1.1, 0), std::pair(0.3, 0)}) {
    cv::Mat image;
    image_with(test::kRed, 3).convertTo(image, -1, factor, offset);
    EXPECT_LT(difference_in(image).largest, 0.1) << factor << ' ' << offset;
  }
}

TEST_F(PrintOfATool, APartOfAnotherColourDiffersInAnyLight) {
  for (const cv::Scalar& handle : {test::kBlack, cv::Scalar(40, 150, 40), cv::Scalar(40, 100, 170)})
    for (const double light : {1.0, 0.35}) {
      cv::Mat image;
      image_with(handle, 2).convertTo(image, -1, light);
      EXPECT_GT(difference_in(image).largest, 5) << handle << ' ' << light;
    }
}

TEST_F(PrintOfATool, AThingAcrossTheContourDoesNotCount) {
  cv::Mat image = image_with(test::kRed, 2);
  cv::rectangle(image, cv::Rect(tool_.x + 5, 20, 45, 110), cv::Scalar(60, 140, 60), cv::FILLED);
  EXPECT_LT(difference_in(image).largest, 0.1);
}

}  // namespace
}  // namespace mbncc::evidence
