// SPDX-License-Identifier: BSD-3-Clause
// Objects taught in colour and searched in grey images, and the reverse.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "matching/matcher_fixture.hpp"

namespace mbncc {
namespace {

using test::LearningImage;
using test::object_from;
using test::place;
using test::texture;

class GreyImagesTest : public test::MatcherTest {
 protected:
  /// The image of a grey camera, in three channels.
  static cv::Mat as_grey(const cv::Mat& image) {
    cv::Mat grey, three;
    cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
    cv::cvtColor(grey, three, cv::COLOR_GRAY2BGR);
    return three;
  }

  LearningImage grey_source() const {
    LearningImage grey = source_;
    grey.image = as_grey(grey.image);
    return grey;
  }

  cv::Mat scene() const {
    cv::Mat scene = texture({320, 240}, 71, 4);
    place(scene, source_, reference_.position(), truth_);
    return scene;
  }

  /// Found, but not graspable, because colours could not be compared.
  void expect_found(const Matcher& matcher, const cv::Mat& image) const {
    const SearchResult result = matcher.find(image);
    ASSERT_EQ(result.matches.size(), 1u);
    expect_at(result.matches[0], truth_);
    EXPECT_GT(result.matches[0].score, 0.9);
    EXPECT_FALSE(result.matches[0].graspable);
    ASSERT_EQ(result.matches[0].reasons.size(), 1u);
    EXPECT_NE(result.matches[0].reasons[0].find("colours cannot be compared"), std::string::npos);
  }

  const Pose2D truth_{150.3, 110.7, 0.9};
};

TEST_F(GreyImagesTest, ShowObjectsTaughtInColour) {
  const cv::Mat grey = as_grey(scene());
  expect_found(matcher(), grey);
  cv::Mat one_channel;
  cv::extractChannel(grey, one_channel, 0);
  expect_found(matcher(), one_channel);
}

TEST_F(GreyImagesTest, DoNotChangeTheColourModel) {
  const auto model = object_from(source_, reference_);
  const cv::Mat before = model->views.front().template_image.clone();
  matcher_of({model}).find(as_grey(scene()));
  EXPECT_EQ(cv::norm(model->views.front().template_image, before, cv::NORM_INF), 0);
}

TEST_F(GreyImagesTest, TeachObjectsFoundInColourImages) {
  expect_found(matcher_of({object_from(grey_source(), reference_)}), scene());
}

TEST_F(GreyImagesTest, ShowObjectsTaughtInGrey) {
  const auto result = matcher_of({object_from(grey_source(), reference_)}).find(as_grey(scene()));
  ASSERT_EQ(result.matches.size(), 1u);
  EXPECT_TRUE(result.matches[0].graspable);
}

// A JPEG image of a metal part on a grey table may have coloured pixels elsewhere only.
TEST_F(GreyImagesTest, AGreyObjectIsGraspableThoughOtherThingsHaveColours) {
  cv::Mat image = as_grey(scene());
  cv::circle(image, {40, 200}, 20, cv::Scalar(30, 30, 220), cv::FILLED);
  const auto result = matcher_of({object_from(grey_source(), reference_)}).find(image);
  ASSERT_EQ(result.matches.size(), 1u);
  expect_at(result.matches[0], truth_);
  EXPECT_TRUE(result.matches[0].graspable);
}

TEST_F(GreyImagesTest, OneGreyViewMakesAnObjectGrey) {
  const auto model = object_from(source_, reference_);
  model->views.push_back(object_from(grey_source(), reference_)->views.front());
  expect_found(matcher_of({model}), scene());
}

TEST_F(GreyImagesTest, ObjectsTaughtEitherWayAreFoundTogether) {
  const LearningImage other(99);
  cv::Mat image = scene();
  const Pose2D other_truth{250.4, 60.2, -1.1};
  place(image, other, reference_.position(), other_truth);
  const auto result = matcher_of({object_from(grey_source(), reference_, "grey"),
                                  object_from(other, reference_, "coloured")})
                          .find(image);
  ASSERT_EQ(result.matches.size(), 2u);
  const bool in_order = result.matches[0].name == "grey";
  expect_at(result.matches[in_order ? 0 : 1], truth_);
  expect_at(result.matches[in_order ? 1 : 0], other_truth);
  for (const auto& match : result.matches) EXPECT_EQ(match.graspable, match.name == "coloured");
}

}  // namespace
}  // namespace mbncc
