// SPDX-License-Identifier: BSD-3-Clause
// Which changed patches belong to something that arrived.
#include <gtest/gtest.h>

#include "learning/change/arrivals.hpp"
#include "learning/change/departure_scores.hpp"
#include "learning/change/departures.hpp"
#include "learning/things_on_platform.hpp"

namespace mbncc {
namespace {

const cv::Rect kLeft(20, 40, 30, 30), kCame(100, 40, 30, 30);

class ArrivalsTest : public testing::Test {
 protected:
  cv::Mat arrivals(const std::vector<cv::Rect>& before, const std::vector<cv::Rect>& after,
                   const cv::Mat& changed) const {
    return change::find_arrivals(test::image_with(before, 11), test::image_with(after, 12), changed,
                                 platform_);
  }

  const change::ColourMixture platform_ = change::ColourMixture::fit(
      test::image_with({}, 13), cv::Mat(test::kPlatformSize, CV_8UC1, cv::Scalar(255)));
};

TEST_F(ArrivalsTest, DistinguishesArrivalsFromDepartures) {
  const cv::Mat came = arrivals({kLeft}, {kCame}, test::map_of({kLeft, kCame}));
  EXPECT_EQ(cv::norm(came, test::map_of({kCame}), cv::NORM_INF), 0);
}

TEST_F(ArrivalsTest, TwoDeparturesAreNoArrivals) {
  EXPECT_EQ(cv::countNonZero(arrivals({kLeft, kCame}, {}, test::map_of({kLeft, kCame}))), 0);
}

TEST_F(ArrivalsTest, WithoutADepartureThereIsNoArrival) {
  EXPECT_EQ(cv::countNonZero(arrivals({}, {kLeft, kCame}, test::map_of({kLeft, kCame}))), 0)
      << "they are much alike, whatever they are";
}

TEST_F(ArrivalsTest, SpecksAreNoArrivals) {
  const cv::Rect speck(100, 40, 4, 4);
  EXPECT_EQ(cv::countNonZero(arrivals({kLeft}, {speck}, test::map_of({kLeft, speck}))), 0);
}

// An edge of the platform that is equal before and after splits a patch that lies across it.
TEST_F(ArrivalsTest, PatchesSplitByAThinSeamAreOne) {
  for (const int gap : {3, 12}) {
    // One half of the departed object looks like an arrival.
    const cv::Rect half(kLeft.br().x + gap, kLeft.y, 12, 30);
    const cv::Mat came = arrivals({kLeft}, {half}, test::map_of({kLeft, half}));
    EXPECT_EQ(cv::countNonZero(came), gap == 3 ? 0 : half.area()) << gap;
  }
}

TEST_F(ArrivalsTest, ArrivalsContainOnlyChangedPixels) {
  // A ring whose hole is narrower than a seam.
  cv::Mat changed = test::map_of({kLeft, kCame});
  changed(cv::Rect(113, 53, 4, 4)).setTo(0);
  const cv::Mat came = arrivals({kLeft}, {kCame}, changed);
  EXPECT_GT(cv::countNonZero(came), 0);
  EXPECT_EQ(cv::countNonZero(came & ~changed), 0);
}

TEST_F(ArrivalsTest, DeparturesContainTheRemovedObject) {
  const auto bytes = [this](const std::vector<cv::Rect>& places, int seed) {
    cv::Mat image8;
    test::image_with(places, seed).convertTo(image8, CV_8U);
    return image8;
  };
  const auto left = [&](const std::vector<cv::Rect>& before, const std::vector<cv::Rect>& after) {
    return cv::countNonZero(
        change::departures(bytes(before, 11), bytes(after, 12), test::map_of({kLeft})) > 0);
  };
  EXPECT_EQ(left({kLeft}, {}), kLeft.area());
  EXPECT_EQ(left({}, {kLeft}), 0);
}

// If the colours before and after are equal, the edges along the border decide.
TEST_F(ArrivalsTest, EdgesDecideIfColoursAreEqual) {
  const cv::Mat labels = cv::Mat_<int>(test::map_of({kLeft})) / 255;
  const cv::Mat bare(test::kPlatformSize, CV_32FC3, cv::Scalar::all(120));
  cv::Mat shown = bare.clone();
  shown(kLeft).setTo(cv::Scalar::all(150));
  // Both greys are equally likely.
  cv::Mat both = bare.clone();
  both(cv::Rect(0, 0, 160, 60)).setTo(cv::Scalar::all(150));
  const change::ColourMixture platform =
      change::ColourMixture::fit(both, cv::Mat(test::kPlatformSize, CV_8UC1, cv::Scalar(255)));
  EXPECT_GT(change::departure_scores(shown, bare, labels, 2, platform)[1], 1.5);
  EXPECT_LT(change::departure_scores(bare, shown, labels, 2, platform)[1], -1.5);
}

}  // namespace
}  // namespace mbncc
