// SPDX-License-Identifier: BSD-3-Clause
// Proposals if an object is partly covered.
#include "matching/search/proposals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "matching/images.hpp"

namespace mbncc::search {
namespace {

const cv::Point2d kReference{60, 60};
const cv::Scalar kColour{40, 90, 220};
const Pose2D kTruth{150, 120, 1.2};

class ProposalsTest : public ::testing::Test {
 protected:
  ProposalsTest() {
    source_.surface.setTo(kColour);
    source_.surface.copyTo(source_.image, source_.map);
    object_ = std::make_unique<prepared::PreparedObject>(
        test::object_from(source_, {kReference.x, kReference.y, 0}), prepared::Engine::kFast);
    free_ = test::texture({320, 240}, 40);
    test::place(free_, source_, kReference, kTruth);
  }

  /// The highest value of a proposal at the true pose; 0 if there is none.
  double value_at_truth(const cv::Mat& image,
                        const std::vector<templates::Candidate>& known = {}) const {
    const prepared::PreparedView& view = object_->views.front();
    const scene::SceneImage scene(image, object_->top_level());
    const proposal::SearchMask everywhere;
    Proposals proposals(view, scene, {{0, 0}, image.size()}, everywhere);
    proposals.search_partial_contours();
    const Pose2D anchor = compose(kTruth, inverse(view.reference_in_anchor));
    double best = 0;
    for (const auto& one : proposals.next_by_partial_contour(200, known, 10)) {
      const double side = 1 << one.level;
      if (cv::norm(side * one.pose.position() - anchor.position()) < 2 * side &&
          angle_distance(one.pose.theta, anchor.theta) * view.shape.radius() < 2 * side)
        best = std::max(best, one.value);
    }
    return best;
  }

  test::LearningImage source_{1};
  std::unique_ptr<prepared::PreparedObject> object_;
  cv::Mat free_;
};

TEST_F(ProposalsTest, ACoveredPartDoesNotLowerTheVisiblePart) {
  cv::Mat covered = free_.clone();
  // The cover has the object's colour, so that only the outline is covered.
  cv::circle(covered, compose(kTruth, {-13, -22, 0}).position(), 22, kColour, cv::FILLED);
  const double free = value_at_truth(free_);
  ASSERT_GT(free, 0);
  EXPECT_GT(value_at_truth(covered), free - 0.03) << "the whole outline loses .05";
}

TEST_F(ProposalsTest, AKnownPlaceIsNotProposedAgain) {
  const Pose2D anchor = compose(kTruth, inverse(object_->views.front().reference_in_anchor));
  const Pose2D beside{anchor.x + 25, anchor.y, anchor.theta};
  EXPECT_EQ(value_at_truth(free_, {{anchor, 0, 1}}), 0);
  EXPECT_GT(value_at_truth(free_, {{beside, 0, 1}}), 0);
}

}  // namespace
}  // namespace mbncc::search
