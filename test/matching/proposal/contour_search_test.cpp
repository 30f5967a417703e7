// SPDX-License-Identifier: BSD-3-Clause
// The coarse search by edges proposes poses in the whole image.
#include "matching/proposal/contour_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "matching/images.hpp"
#include "matching/proposal/response_peaks.hpp"
#include "matching/template/map_geometry.hpp"

namespace mbncc::proposal {
namespace {

const cv::Point2d kAnchor{60, 60};

class ContourSearchTest : public ::testing::Test {
 protected:
  std::vector<templates::Candidate> search(const cv::Mat& image, std::size_t most,
                                           OutlinePart part = OutlinePart::kWhole) const {
    cv::Mat level = image;
    for (int k = 0; k < bank_.level(); ++k) cv::pyrDown(level, level);
    return contour_search(bank_, scene::SceneLevel(level, bank_.level()), {{0, 0}, level.size()},
                          most, {}, part);
  }

  /// The background with a bright object at `truth`.
  cv::Mat with_object(const Pose2D& truth) const {
    cv::Mat image = ground_.clone();
    test::LearningImage bright = source_;
    bright.surface.setTo(cv::Scalar::all(240));
    test::place(image, bright, kAnchor, truth);
    return image;
  }

  /// The best response for a pose at `truth`; 0 if there is none.
  double response_at(const Pose2D& truth, const std::vector<templates::Candidate>& poses) const {
    const double side = 1 << bank_.level();
    double best = 0;
    for (const auto& found : poses)
      if (cv::norm(side * found.pose.position() - truth.position()) < 3 * side &&
          angle_distance(found.pose.theta, truth.theta) < 0.2)
        best = std::max(best, found.value);
    return best;
  }

  static std::vector<double> values(const std::vector<templates::Candidate>& poses) {
    std::vector<double> values;
    for (const auto& pose : poses) values.push_back(pose.value);
    return values;
  }

  const test::LearningImage source_{1};
  const ContourBank bank_{templates::MapGeometry(source_.map), kAnchor};
  const cv::Mat ground_ = test::texture({320, 240}, 5);
};

TEST(ResponsePeaks, BestPeaksComeFirstDespiteEqualSums) {
  std::vector<ResponsePeak> peaks;
  for (int i = 0; i < 500; ++i) peaks.emplace_back(1 + i * 37 % 23, i * 11 % 64, i, i % 7);
  auto sorted = peaks;
  std::sort(sorted.begin(), sorted.end());
  const auto places = [](auto first, auto last) {
    std::vector<int> found;
    std::transform(first, last, std::back_inserter(found),
                   [](const ResponsePeak& one) { return one.x(); });
    return found;
  };
  for (const std::size_t count : {0, 1, 100, 499, 500, 600}) {
    const auto end = put_best_first(peaks, count);
    std::sort(peaks.begin(), end);
    const auto wanted = std::min(count, sorted.size());
    EXPECT_EQ(places(peaks.begin(), end), places(sorted.begin(), sorted.begin() + wanted)) << count;
  }
}

TEST_F(ContourSearchTest, BestPosesComeFirstAndInOrder) {
  const auto all = values(search(ground_, 20000));
  const auto some = values(search(ground_, 400));
  EXPECT_TRUE(std::is_sorted(some.rend() - 50, some.rend()));
  EXPECT_EQ(some.front(), *std::max_element(all.begin(), all.end()));
}

TEST_F(ContourSearchTest, BestPosesOfAQuarterTurnAreApart) {
  const auto poses = search(ground_, 400);
  for (std::size_t i = 0; i < 50; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const bool beside = std::abs(poses[i].pose.x - poses[j].pose.x) < 3 &&
                          std::abs(poses[i].pose.y - poses[j].pose.y) < 3;
      EXPECT_FALSE(beside && angle_distance(poses[i].pose.theta, poses[j].pose.theta) < 1e-3);
    }
}

TEST_F(ContourSearchTest, APlaceIsProposedAtManyRotations) {
  const auto poses = search(ground_, 20000);
  const auto here =
      std::count_if(poses.begin(), poses.end(), [](const templates::Candidate& candidate) {
        return std::abs(candidate.pose.x - 40) < 3 && std::abs(candidate.pose.y - 30) < 3;
      });
  EXPECT_GT(here, 6);
}

TEST_F(ContourSearchTest, FindsAnObjectAmongTheBestPoses) {
  const Pose2D truth{150, 120, 1.2};
  EXPECT_GT(response_at(truth, search(with_object(truth), 20)), 0);
}

TEST_F(ContourSearchTest, ACoveredPartDoesNotLowerTheBestThreeQuarters) {
  const Pose2D truth{150, 120, 1.2};
  const cv::Mat free = with_object(truth);
  cv::Mat covered = free.clone();
  covered(cv::Rect(90, 40, 130, 60)).setTo(120);
  const auto left = [&](OutlinePart part) {
    const auto response = [&](const cv::Mat& image) {
      return response_at(truth, search(image, 8000, part));
    };
    return response(covered) / response(free);
  };
  EXPECT_LT(left(OutlinePart::kWhole), 0.9);
  EXPECT_GT(left(OutlinePart::kThreeQuarters), 0.97);
}

}  // namespace
}  // namespace mbncc::proposal
