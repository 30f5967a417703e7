// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/explanation.hpp"

#include <opencv2/imgproc.hpp>

#include "matching/matcher_fixture.hpp"

namespace mbncc {
namespace {

using Outcome = Explanation::Outcome;

class ExplanationTest : public test::MatcherTest {
 protected:
  Explanation at(cv::Point2d place, const SearchConfig& config = {}) {
    return explain_place({object_}, config, image_, place).at(0);
  }

  static bool says(const Explanation& explanation, const std::string& text) {
    const auto lines = lines_of(explanation);
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.find(text) != std::string::npos;
    });
  }

  const std::shared_ptr<const ObjectModel> object_ = test::object_from(source_, reference_);
  const Pose2D truth_{150, 110, 0.7};
  const cv::Mat image_ = scene();

 private:
  cv::Mat scene() const {
    cv::Mat drawn = test::texture({320, 240}, 77, 5);
    test::place(drawn, source_, reference_.position(), truth_);
    return drawn;
  }
};

TEST_F(ExplanationTest, ExplanationOfADetectionEqualsTheMatch) {
  Matcher matcher = matcher_of({object_});
  const auto found = matcher.find(image_).matches;
  ASSERT_EQ(found.size(), 1u);
  const Explanation explanation = at(truth_.position());
  EXPECT_EQ(explanation.outcome, found[0].graspable ? Outcome::kGraspable : Outcome::kReported);
  EXPECT_DOUBLE_EQ(explanation.score, found[0].score);
  EXPECT_FALSE(explanation.parts.empty());
  for (const auto& part : explanation.parts) EXPECT_GE(part.lacking, -1e-9) << part.name;
}

TEST_F(ExplanationTest, AGreyImageIsComparedWithTheGreyLesson) {
  cv::Mat grey;
  cv::cvtColor(image_, grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, grey, cv::COLOR_GRAY2BGR);
  const Explanation explanation = explain_place({object_}, {}, grey, truth_.position()).at(0);
  const auto colours = std::find_if(
      explanation.parts.begin(), explanation.parts.end(),
      [](const ScorePart& part) { return part.name.find("difference of colours") == 0; });
  ASSERT_NE(colours, explanation.parts.end());
  EXPECT_LT(colours->value, 4);
}

TEST_F(ExplanationTest, ZeroHasNoSign) {
  for (const auto& line : lines_of(at(truth_.position())))
    EXPECT_EQ(line.find("-0.0 "), std::string::npos) << line;
  EXPECT_FALSE(says(at(truth_.position()), "-0.0,"));
}

TEST_F(ExplanationTest, NamesTheThresholdThatFailed) {
  SearchConfig strict;
  strict.min_score = 1;
  const Explanation explanation = at(truth_.position(), strict);
  EXPECT_EQ(explanation.outcome, Outcome::kRejected);
  EXPECT_TRUE(says(explanation, "below min_score 1.00"));
  ASSERT_FALSE(explanation.checks.empty());
  EXPECT_FALSE(explanation.checks[0].passed);
}

TEST_F(ExplanationTest, ANarrowFailureIsVisibleInItsDigits) {
  Explanation explanation = at(truth_.position());
  explanation.checks = {{"confirm_score", 0.99996, 1, false, false},
                        {"min_score", 0.75, 0.5, true, true}};
  EXPECT_TRUE(says(explanation, "confirm_score 1.00000 FAILED with 0.99996"))
      << lines_of(explanation)[3];
  EXPECT_TRUE(says(explanation, "min_score 0.50 passed with 0.75"));
  explanation.outcome = Outcome::kRejected;
  explanation.score = 0.4999;
  explanation.checks = {{"min_score", 0.4999, 0.5, false, true}};
  EXPECT_TRUE(says(explanation, "score 0.4999: not reported"));
  EXPECT_TRUE(says(explanation, "below min_score 0.5000."));
}

TEST_F(ExplanationTest, RatesAPlaceThatNoSearchProposes) {
  const Explanation explanation = at({20, 20});
  EXPECT_LT(explanation.score, 0.3);
  EXPECT_FALSE(lines_of(explanation).empty());
  EXPECT_NE(explanation.outcome, Outcome::kGraspable);
}

TEST_F(ExplanationTest, OddsAreTheSumOfTheirParts) {
  const Explanation explanation = at(truth_.position());
  const LogOdds& odds = explanation.odds;
  EXPECT_GT(odds.evidence, 3);
  EXPECT_NEAR(odds.evidence - odds.colour - odds.mirror - odds.print + odds.rotations() -
                  odds.clutter + odds.calibration,
              odds.total(), 1e-9);
  EXPECT_NEAR(explanation.score, 1 / (1 + std::exp(-odds.total())), 1e-9);
}

TEST_F(ExplanationTest, ExplanationOfAGreyImageIsGrey) {
  cv::Mat grey;
  cv::cvtColor(image_, grey, cv::COLOR_BGR2GRAY);
  const auto explanation = explain_place({object_}, {}, grey, truth_.position()).at(0);
  EXPECT_LT(explanation.odds.colour, 2);
  EXPECT_NEAR(explanation.odds.rotations(), 0, 1e-9);
}

TEST_F(ExplanationTest, ExplanationHasTheSizeOfTheObjectInTheImage) {
  constexpr double kScale = 1.05;
  cv::Mat larger;
  cv::resize(image_, larger, {}, kScale, kScale, cv::INTER_CUBIC);
  const cv::Point2d there = kScale * truth_.position();
  const auto explanation = explain_place({object_}, {}, larger, there).at(0);
  EXPECT_NEAR(explanation.scale, kScale, 0.01);
  EXPECT_GT(explanation.odds.evidence, at(truth_.position()).odds.evidence - 1);
}

TEST_F(ExplanationTest, NamesLightOfAnotherColour) {
  const cv::Scalar gains(0.85, 1, 1.2);
  cv::Mat redder;
  cv::multiply(image_, gains, redder);
  const auto explanation = explain_place({object_}, {}, redder, truth_.position()).at(0);
  const auto cast = std::find_if(explanation.parts.begin(), explanation.parts.end(),
                                 [](const auto& part) { return part.name == "cast of the light"; });
  ASSERT_NE(cast, explanation.parts.end());
  EXPECT_GT(cast->lacking, 0.5);
}

TEST_F(ExplanationTest, ABetterObjectAtThePlaceIsNamed) {
  auto twin = std::make_shared<ObjectModel>(*object_);
  twin->name = "twin";
  const auto explanations = explain_place({object_, twin}, {}, image_, truth_.position());
  ASSERT_EQ(explanations.size(), 2u);
  const bool covered = explanations[1].covered_by == explanations[0].name;
  const bool rivals = !explanations[0].competitors.empty();
  EXPECT_TRUE(covered || rivals);
}

TEST_F(ExplanationTest, RefusesUnusableRequests) {
  EXPECT_THROW(at({-1, 5}), std::invalid_argument);
  EXPECT_THROW(at({1e6, 5}), std::invalid_argument);
  EXPECT_THROW(explain_place({object_}, {}, image_, {5, 5}, {"unknown"}), std::invalid_argument);
  auto disabled = std::make_shared<ObjectModel>(*object_);
  disabled->enabled = false;
  EXPECT_THROW(explain_place({disabled}, {}, image_, {5, 5}, {disabled->name}),
               std::invalid_argument);
  EXPECT_TRUE(explain_place({disabled}, {}, image_, {5, 5}).empty());
}

TEST_F(ExplanationTest, ObjectsThatCannotBeSearchedForAreRefusedOnlyIfNamed) {
  cv::Mat map = cv::Mat::zeros(420, 420, CV_8UC1);
  map(cv::Rect(20, 20, 380, 380)) = 255;
  const auto large = test::object_from(test::LearningImage(7, map), {210, 210, 0}, "large");
  const cv::Mat strip = image_.rowRange(100, 120);
  const auto explained = explain_place({object_, large}, {}, strip, {150, 10});
  ASSERT_EQ(explained.size(), 1u);
  EXPECT_EQ(explained[0].name, object_->name);
  EXPECT_THROW(explain_place({object_, large}, {}, strip, {150, 10}, {"large"}),
               std::invalid_argument);
}

TEST_F(ExplanationTest, ExplanationIsDrawn) {
  const auto explanations = explain_place({object_}, {}, image_, truth_.position());
  const cv::Mat drawn = draw_explanation(image_, truth_.position(), explanations);
  EXPECT_EQ(drawn.size(), image_.size());
  EXPECT_GT(cv::norm(drawn, image_, cv::NORM_INF), 0);
}

}  // namespace
}  // namespace mbncc
