// SPDX-License-Identifier: BSD-3-Clause
// Colours choose among poses that lie on edges.
#include "matching/search/colour_ranking.hpp"

#include <gtest/gtest.h>

#include "matching/images.hpp"

namespace mbncc::search {
namespace {

const cv::Scalar kTint{-60, 0, 60};

class ColourRankingTest : public ::testing::Test {
 protected:
  ColourRankingTest() {
    source_.surface += kTint;
    source_.surface.copyTo(source_.image, source_.map);
    object_ = std::make_unique<prepared::PreparedObject>(test::object_from(source_, {60, 60, 0}),
                                                         prepared::Engine::kFast);
    cv::Mat image = test::texture({320, 240}, 9, 4) - 0.5 * kTint;
    test::place(image, source_, view().anchor, truth_);
    scene_ = std::make_unique<scene::SceneImage>(image, object_->top_level());
  }

  const prepared::PreparedView& view() const { return object_->views.front(); }

  /// Poses all over the image; the second last one is the true one, although edges rank it last.
  std::vector<templates::Candidate> poses() const {
    std::vector<templates::Candidate> poses;
    for (int x = 40; x <= 280; x += 20)
      for (int y = 40; y <= 200; y += 20)
        poses.push_back({{double(x), double(y), 0.1 * x}, 0, 0.6});
    poses.insert(poses.end() - 1, {truth_, 0, 0.55});
    return poses;
  }

  bool is_truth(const templates::Candidate& candidate) const {
    return cv::norm(candidate.pose.position() - truth_.position()) < 1e-9;
  }

  const Pose2D truth_{170, 110, 0.7};
  test::LearningImage source_{1};
  std::unique_ptr<prepared::PreparedObject> object_;
  std::unique_ptr<scene::SceneImage> scene_;
};

TEST_F(ColourRankingTest, MatchingColoursRankAboveBetterEdges) {
  const auto best = ranked_by_colours(view(), *scene_, poses());
  ASSERT_EQ(best.size(), poses().size());
  EXPECT_TRUE(is_truth(best.front()));
  for (std::size_t i = 1; i < best.size(); ++i) EXPECT_GE(best[i - 1].value, best[i].value);
}

TEST_F(ColourRankingTest, ColoursDoNotOutweighEdges) {
  auto all = poses();
  all.front().value = 1;
  all[all.size() - 2].value = 0;
  EXPECT_FALSE(is_truth(ranked_by_colours(view(), *scene_, all).front()));
}

TEST_F(ColourRankingTest, NoPosesAreNoFault) {
  EXPECT_TRUE(ranked_by_colours(view(), *scene_, {}).empty());
}

TEST_F(ColourRankingTest, EdgesDecideInImagesTooSmallForColours) {
  const scene::SceneImage small(test::texture({16, 16}, 3), 0);
  auto all = poses();
  all[7].value = 0.7;
  const auto best = ranked_by_colours(view(), small, all);
  ASSERT_EQ(best.size(), all.size());
  EXPECT_EQ(best.front().value, 0.7);
}

}  // namespace
}  // namespace mbncc::search
