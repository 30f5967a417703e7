// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/colour_parts.hpp"

#include <gtest/gtest.h>

#include <array>
#include <opencv2/imgproc.hpp>

#include "matching/evidence/tool_fixture.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/scene/scene_image.hpp"
#include "matching/template/colours_beside.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::evidence {
namespace {

using test::kBlack;
using test::kRed;
using test::kSteel;
using test::kTable;

class ColourPartsTest : public test::ToolTest {
 protected:
  double difference_in(const cv::Mat& image) const { return difference_in(image, tool()); }

  /// Colour difference at the pose at which the object was learned.
  static double difference_in(const cv::Mat& image, std::shared_ptr<ObjectModel> model) {
    const prepared::PreparedObject object(std::move(model), prepared::Engine::kFast);
    const prepared::PreparedView& view = object.views.front();
    const scene::SceneImage scene(image, 0);
    const scene::SceneLevel& level = scene.levels[0];
    const Pose2D at = compose({150, 72, 0}, inverse(view.reference_in_anchor));
    templates::SurfaceSample sample;
    templates::ContourSample contour;
    view.fine.surface.sample(level.whole(), at, sample);
    templates::read_contour(view.fine.contour, level.whole().edges, at, 1, contour);
    return view.parts.worst_difference(view.fine.surface, sample, contour,
                                       background_colour(view.fine.contour, level, at));
  }
};

TEST_F(ColourPartsTest, TheObjectItselfDiffersLittleInAnyLight) {
  EXPECT_LT(difference_in(image_with(kRed, 2)), 0.04);
  for (const auto& [factor, offset] :
       {std::pair(0.6, 40), std::pair(0.8, -10), std::pair(1.1, 0), std::pair(0.3, 0)}) {
    cv::Mat image;
    image_with(kRed, 3).convertTo(image, -1, factor, offset);
    EXPECT_LT(difference_in(image), 0.1) << factor << ' ' << offset;
  }
}

TEST_F(ColourPartsTest, APartOfAnotherColourDiffers) {
  EXPECT_GT(difference_in(image_with(kBlack, 2)), 0.3);
  EXPECT_GT(difference_in(image_with({40, 150, 40}, 2)), 0.3);
}

TEST_F(ColourPartsTest, APartOfAnotherColourDiffersAsMuchInDimLight) {
  const cv::Scalar orange(40, 100, 170);
  cv::Mat dim;
  image_with(orange, 2).convertTo(dim, -1, 0.35);
  EXPECT_NEAR(difference_in(dim), difference_in(image_with(orange, 2)), 0.05);
}

TEST_F(ColourPartsTest, APlainSurfaceInDimLightHasItsOwnColour) {
  cv::Mat map = cv::Mat::zeros(150, 300, CV_8UC1), dim;
  map(tool_) = 255;
  cv::Mat plain(150, 300, CV_8UC3, kTable);
  plain(tool_) = cv::Scalar(60, 90, 120);
  plain.convertTo(dim, -1, 0.4);
  EXPECT_LT(difference_in(dim, object_of(plain, map)), 0.05);
}

TEST_F(ColourPartsTest, SmallPartsOfAPrintCountTogether) {
  // Four shades of red, each of a fiftieth of the tool.
  const auto printed = [&](const std::array<cv::Scalar, 4>& shades) {
    cv::Mat image(150, 300, CV_8UC3, kTable);
    image(tool_) = kSteel;
    for (int k = 0; k < 4; ++k)
      image(cv::Rect(tool_.x + 30 * k + 20, tool_.y + 8, 9, 8)) = shades[k];
    return image;
  };
  const std::array<cv::Scalar, 4> reds{cv::Scalar(30, 30, 90), cv::Scalar(40, 40, 170),
                                       cv::Scalar(90, 90, 200), cv::Scalar(20, 70, 190)};
  cv::Mat map = cv::Mat::zeros(150, 300, CV_8UC1);
  map(tool_) = 255;
  const auto model = object_of(printed(reds), map);
  EXPECT_LT(difference_in(printed(reds), model), 0.04);
  EXPECT_GT(difference_in(printed({kBlack, kBlack, kBlack, kBlack}), model), 0.3);
}

TEST_F(ColourPartsTest, AThingAcrossTheContourDoesNotCount) {
  cv::Mat image = image_with(kRed, 2);
  cv::rectangle(image, cv::Rect(tool_.x + 5, 20, 45, 110), cv::Scalar(60, 140, 60), cv::FILLED);
  EXPECT_LT(difference_in(image), 0.1);
}

TEST_F(ColourPartsTest, AHalfCoveredPartDiffersToo) {
  cv::Mat image = image_with(kBlack, 2);
  cv::rectangle(image, cv::Rect(tool_.x + 5, 20, 22, 110), cv::Scalar(60, 140, 60), cv::FILLED);
  EXPECT_GT(difference_in(image), 0.3);
}

TEST_F(ColourPartsTest, TheGroundExplainsOnlyAnEqualColourShift) {
  // Everything is more yellow: the table slightly, the head much more.
  cv::Mat image = image_with(kRed, 2);
  cv::Mat head = image(cv::Rect(tool_.x + kHandle, tool_.y, kLength - kHandle, kWidth)).clone();
  cv::multiply(image, cv::Scalar(0.9, 1, 1), image);
  cv::multiply(head, cv::Scalar(0.55, 1, 1), head);
  head.copyTo(image(cv::Rect(tool_.x + kHandle, tool_.y, kLength - kHandle, kWidth)));
  EXPECT_GT(difference_in(image), 0.2);
}

TEST_F(ColourPartsTest, GroundInsideTheMapMayChange) {
  // The learned map includes a strip of green platform along the tool, which is then found on a red
  // platform.
  const cv::Scalar green(60, 150, 60), red(60, 60, 150);
  const auto on_ground = [&](const cv::Scalar& ground, std::uint64_t seed) {
    cv::Mat image(150, 300, CV_8UC3, ground);
    image(tool_) = kSteel;
    add_noise(image, seed);
    return image;
  };
  const cv::Rect strip(tool_.x, tool_.br().y, tool_.width, 8);
  cv::Mat map = cv::Mat::zeros(150, 300, CV_8UC1);
  map(tool_ | strip) = 255;
  EXPECT_LT(difference_in(on_ground(red, 2), object_of(on_ground(green, 1), map)), 0.1);
}

TEST_F(ColourPartsTest, TheGroundBesideNarrowObjectsIsNotCounted) {
  const cv::Rect rod(75, 70, kLength, 2);
  const auto rod_on = [&](const cv::Scalar& ground, const cv::Scalar& colour, std::uint64_t seed) {
    cv::Mat image(150, 300, CV_8UC3, ground);
    image(rod) = kSteel;
    image(cv::Rect(rod.tl(), cv::Size(kHandle, rod.height))) = colour;
    cv::GaussianBlur(image, image, {}, 0.8);
    add_noise(image, seed);
    return image;
  };
  cv::Mat map = cv::Mat::zeros(150, 300, CV_8UC1);
  map(rod) = 255;
  const auto object = object_of(rod_on(kTable, kRed, 1), map);
  const cv::Scalar wood(90, 130, 170);
  // Above 0.25, a part counts as having another colour, see conclusion.cpp.
  EXPECT_LT(difference_in(rod_on(wood, kRed, 2), object), 0.2);
  EXPECT_GT(difference_in(rod_on(wood, {60, 150, 60}, 2), object), 0.25);
}

TEST_F(ColourPartsTest, RandomStateIsNeitherUsedNorChanged) {
  const cv::Mat image = image_with(kRed, 2);
  cv::theRNG().state = 77;
  const double first = difference_in(image);
  EXPECT_EQ(cv::theRNG().state, 77u);
  cv::theRNG().state = 12345;
  EXPECT_EQ(difference_in(image), first);
}

TEST_F(ColourPartsTest, ALookAlikeIsNotDetected) {
  Matcher matcher;
  matcher.set_objects({tool()});
  const auto found = matcher.find(image_with(kRed, 2)).matches;
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].pose.x, 150, 0.5);
  EXPECT_TRUE(matcher.find(image_with(kBlack, 2)).matches.empty());
}

}  // namespace
}  // namespace mbncc::evidence
