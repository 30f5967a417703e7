// SPDX-License-Identifier: BSD-3-Clause
// A view is searched again, with a larger budget, if the first search may have missed instances.
#include "matching/search/view_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "matching/images.hpp"
#include "matching/search/occupied_search.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::search {
namespace {

const cv::Point2d kReference{52, 60};
const cv::Scalar kBrown{100, 118, 140};

/// A hook in one colour that does not occur on the busy grey background.
test::LearningImage hook() {
  constexpr int kWidth = 2;
  cv::Mat map = cv::Mat::zeros(120, 120, CV_8UC1);
  map(cv::Rect(45, 48, kWidth, 22 + kWidth)) = 255;
  map(cv::Rect(45, 70, 12 + kWidth, kWidth)) = 255;
  test::LearningImage source(1, map);
  source.surface.setTo(kBrown);
  source.surface.copyTo(source.image, source.map);
  return source;
}

/// A grey background with edges everywhere.
cv::Mat busy_ground(std::uint64_t seed) {
  cv::Mat grey, ground;
  cv::cvtColor(test::texture({320, 240}, seed, 1.0), grey, cv::COLOR_BGR2GRAY);
  cv::cvtColor(grey, ground, cv::COLOR_GRAY2BGR);
  return (ground - cv::Scalar::all(120)) * 2 + cv::Scalar::all(120);
}

class ViewSearchTest : public ::testing::Test {
 protected:
  ViewSearchTest() : ViewSearchTest(hook()) {}
  explicit ViewSearchTest(const test::LearningImage& source)
      : source_(source),
        object_(test::object_from(source_, {52, 60, 0}), prepared::Engine::kFast) {}

  std::vector<decision::Detection> search(const cv::Mat& image, SearchMode mode) const {
    return search_view(object_, object_.views.front(),
                       scene::SceneImage(image, object_.top_level()), {{0, 0}, image.size()}, mode);
  }

  static bool lies_at(const decision::Detection& detection, const Pose2D& truth) {
    const Pose2D pose = compose(detection.pose, detection.view->reference_in_anchor);
    return cv::norm(pose.position() - truth.position()) < 2 &&
           angle_distance(pose.theta, truth.theta) < to_radians(4.);
  }

  /// Number of images, out of twelve, in which the best detection is at the true position.
  int found_by(SearchMode mode) const {
    int found = 0;
    for (unsigned k = 0; k < 12; ++k) {
      cv::Mat image = busy_ground(20 + k);
      const Pose2D truth{90.0 + 11 * k, 80.0 + 7 * k, 0.5 * k};
      test::place(image, source_, kReference, truth);
      const auto detections = search(image, mode);
      found += !detections.empty() && lies_at(detections.front(), truth);
    }
    return found;
  }

  test::LearningImage source_;
  prepared::PreparedObject object_;
};

TEST_F(ViewSearchTest, TheSecondPassFindsMoreObjects) {
  const int at_once = found_by(SearchMode::kReduced), in_the_end = found_by(SearchMode::kThorough);
  EXPECT_LT(at_once, 9);
  EXPECT_GT(in_the_end, at_once);
}

// A reduced search misses some, which then have to compete where another object was found.
TEST_F(ViewSearchTest, AMatcherComparesAMissedObjectAtThePlaceOfAnother) {
  Matcher matcher;
  matcher.set_objects({test::object_from(source_, {52, 60, 0})});
  const prepared::PreparedView& view = object_.views.front();
  int alone = 0, compared = 0;
  for (unsigned k = 0; k < 12; ++k) {
    cv::Mat image = busy_ground(20 + k);
    const Pose2D truth{90.0 + 11 * k, 80.0 + 7 * k, 0.5 * k};
    test::place(image, source_, kReference, truth);
    SearchRequest request;
    request.among = 50;
    const auto candidates_at_truth = [&] {
      const SearchResult result = matcher.find(image, request);
      const auto is_there = [&](const auto& one, cv::Point2d position) {
        return one.name == "object" && cv::norm(position - truth.position()) < 2;
      };
      return std::any_of(result.matches.begin(), result.matches.end(),
                         [&](const Match& one) { return is_there(one, one.pose.position()); }) ||
             std::any_of(result.rivals.begin(), result.rivals.end(),
                         [&](const Rival& one) { return is_there(one, one.position); });
    };
    alone += candidates_at_truth();
    const Pose2D anchor = compose(truth, inverse(view.reference_in_anchor));
    request.occupied = {{{anchor.position(), view.shape.radius()}, cv::contourArea(view.outline)}};
    compared += candidates_at_truth();
  }
  EXPECT_GT(compared, alone);
}

/// A plate with a half-turn symmetry except for a thin appendix, which displaces the centre of its
/// excircle by 20 px and its centroid by two.
test::LearningImage whiskered_plate() {
  cv::Mat map = cv::Mat::zeros(120, 140, CV_8UC1);
  map(cv::Rect(15, 48, 70, 24)) = 255;
  map(cv::Rect(85, 59, 40, 2)) = 255;
  test::LearningImage source(1, map);
  source.surface.setTo(kBrown);
  source.surface.copyTo(source.image, source.map);
  return source;
}

class WhiskeredPlateTest : public ViewSearchTest {
 protected:
  WhiskeredPlateTest() : ViewSearchTest(whiskered_plate()) {}
};

TEST_F(WhiskeredPlateTest, ProposesTheHalfTurnThatCoversThePlate) {
  const Pose2D truth{150, 120, 0.8};
  cv::Mat image = test::texture({320, 240}, 77, 5);
  test::place(image, source_, kReference, truth);
  const prepared::PreparedView& view = object_.views.front();
  const cv::Point anchor = compose(truth, inverse(view.reference_in_anchor)).position();
  const auto found =
      search_view(object_, view, scene::SceneImage(image, object_.top_level()),
                  {anchor - cv::Point(10, 10), cv::Size(21, 21)}, SearchMode::kThorough);
  const cv::Point2d middle = cv::Point2d(49.5, 59.5) - kReference;  // of the plate
  const Pose2D half = compose(truth, {2 * middle.x, 2 * middle.y, kPi});
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(lies_at(found.front(), truth));
  EXPECT_TRUE(std::any_of(found.begin(), found.end(), [&](const decision::Detection& one) {
    return lies_at(one, half);
  })) << "the search proposes nothing there";
}

TEST_F(WhiskeredPlateTest, ProposesTheHalfTurnAtEachOfManyPlaces) {
  const cv::Point2d middle = cv::Point2d(49.5, 59.5) - kReference;
  cv::Mat image = test::texture({720, 720}, 78, 5);
  std::vector<Pose2D> truths;
  for (int k = 0; k < 12; ++k) {
    truths.push_back({90.0 + 180 * (k % 4), 90.0 + 180 * (k / 4), 0.7 * k});
    test::place(image, source_, kReference, truths.back());
  }
  const auto found = search(image, SearchMode::kThorough);
  for (const Pose2D& truth : truths) {
    const Pose2D half = compose(truth, {2 * middle.x, 2 * middle.y, kPi});
    EXPECT_TRUE(std::any_of(found.begin(), found.end(),
                            [&](const decision::Detection& one) { return lies_at(one, half); }))
        << truth.x << ", " << truth.y;
  }
}

TEST(SearchOccupied, RatesAnObjectAtThePlaceOfAnother) {
  const test::LearningImage source(1);
  const prepared::PreparedObject object(test::object_from(source, {52, 60, 0}),
                                        prepared::Engine::kFast);
  const prepared::PreparedView& view = object.views.front();
  cv::Mat image = test::texture({320, 240}, 77, 5);
  const Pose2D truth{150, 120, 0.8};
  test::place(image, source, kReference, truth);
  const scene::SceneImage scene(image, object.top_level());
  const Pose2D anchor = compose(truth, inverse(view.reference_in_anchor));
  const auto judged = [&](double size, const std::vector<decision::Detection>& found) {
    const Footprint there{{anchor.position(), size * view.shape.radius()},
                          size * size * cv::contourArea(view.outline)};
    return search_occupied(object, scene, {there}, found);
  };
  const auto detections = judged(1, {});
  ASSERT_FALSE(detections.empty());
  EXPECT_LT(cv::norm(detections.front().pose.position() - anchor.position()), 1);
  EXPECT_LT(angle_distance(detections.front().pose.theta, anchor.theta), to_radians(1.));
  EXPECT_TRUE(judged(1, detections).empty()) << "found already";
  std::vector<decision::Detection> neighbour{detections.front()};
  neighbour.front().pose.x += 0.5 * view.shape.radius();
  EXPECT_FALSE(judged(1, neighbour).empty()) << "a neighbour that covers it in part";
  EXPECT_TRUE(judged(1.3, {}).empty()) << "larger things are no look-alikes";
}

}  // namespace
}  // namespace mbncc::search
