// SPDX-License-Identifier: BSD-3-Clause
// Reliability measures of a finished cut and its map.
#include "learning/segmentation/cut_evidence.hpp"

#include <gtest/gtest.h>

#include "learning/segmentation/graph_cut.hpp"
#include "learning/segmentation/half_smoothness.hpp"
#include "learning/segmentation/map_measures.hpp"

namespace mbncc::segmentation {
namespace {

const cv::Size kSize(80, 60);
const cv::Rect kRegion(10, 10, 60, 40), kObject(24, 20, 30, 20);

cv::Mat map_of(const cv::Rect& place) {
  cv::Mat map = cv::Mat::zeros(kSize, CV_8UC1);
  map(place).setTo(255);
  return map;
}

/// Smoothness of images without edges: a label change between neighbours has a low cost.
Smoothness even() {
  Smoothness smoothness;
  smoothness.strength = 0.1F;
  for (auto& weights : smoothness.weights)
    weights = cv::Mat(kSize, CV_32FC1, cv::Scalar(smoothness.strength));
  smoothness.weights[0].col(0).setTo(0);
  smoothness.weights[1].col(0).setTo(0);
  smoothness.weights[3].col(kSize.width - 1).setTo(0);
  for (const int k : {1, 2, 3}) smoothness.weights[k].row(0).setTo(0);
  return smoothness;
}

class CutEvidenceTest : public testing::Test {
 protected:
  CutEvidence evidence() const {
    FinishedCut cut;
    cut.map = map_of(kObject);
    cut.coarse = coarse_cut(unary_, half_);
    cut.inside = map_of(region_);
    cut.unary = unary_;
    cut.changed = changed_;
    cut.object_like = object_like_;
    cut.intruders = intruders_;
    cut.confirmed = confirmed_;
    return cut_evidence(cut, smoothness_, half_);
  }

  /// [log-odds] of pixels on and off the object.
  void prefer(float on, float off) {
    unary_.setTo(off);
    unary_(kObject).setTo(on);
  }

  cv::Rect region_ = kRegion;
  cv::Mat intruders_, confirmed_;
  Smoothness smoothness_ = even();
  const Smoothness half_ = half_resolution(even());
  cv::Mat unary_ = cv::Mat(kSize, CV_32FC1, cv::Scalar(-8));
  cv::Mat object_like_ = map_of(kObject);
  cv::Mat changed_ = cv::Mat_<float>(map_of(kObject)) / 255;
};

TEST_F(CutEvidenceTest, AClearCutIsStable) {
  prefer(8, -8);
  EXPECT_GT(evidence().stability, 0.95);
}

TEST_F(CutEvidenceTest, ACutLostAtSlightlyLowerBalanceIsUnstable) {
  prefer(1, -8);
  EXPECT_LT(evidence().stability, 0.1);
}

TEST_F(CutEvidenceTest, ACutThatSpreadsAtSlightlyHigherBalanceIsUnstable) {
  prefer(8, -1);
  EXPECT_LT(evidence().stability, 0.3);
}

TEST_F(CutEvidenceTest, MeasuresChangeOutsideTheMap) {
  prefer(8, -8);
  EXPECT_EQ(evidence().change_outside, 0);
  EXPECT_EQ(evidence().change_beside, 0);
  changed_(cv::Rect(60, 20, 8, 10)).setTo(1);  // in the region
  EXPECT_NEAR(evidence().change_beside, 80.0 / kObject.area(), 1e-6);
  confirmed_ = map_of(kRegion);
  EXPECT_EQ(evidence().change_beside, 0) << "the operator has excluded it";
  changed_(cv::Rect(0, 0, 80, 5)).setTo(1);
  EXPECT_NEAR(evidence().change_outside, 400.0 / (kSize.area() - kRegion.area()), 1e-6);
  changed_.setTo(0.6);
  EXPECT_EQ(evidence().change_outside, 0) << "not surely";
}

TEST_F(CutEvidenceTest, MeasuresHowMuchTheMapTouchesTheRegionsEdge) {
  const cv::Mat inside = map_of(kRegion);
  EXPECT_EQ(region_touch(map_of(kObject), inside), 0);
  EXPECT_EQ(region_touch(map_of(kRegion), inside), 1);
  // One of four sides touches the edge.
  EXPECT_NEAR(region_touch(map_of({10, 20, 20, 20}), inside), 0.28, 0.03);
}

TEST_F(CutEvidenceTest, MeasuresHowMuchTheRegionCutsOff) {
  prefer(8, -8);
  region_ = cv::Rect(10, 10, kObject.br().x - 10, 40);  // ends where the object does
  EXPECT_EQ(evidence().cut_off, 0) << "it ends there, too";
  changed_(cv::Rect(kObject.br().x, kObject.y, 10, kObject.height)).setTo(1);
  EXPECT_EQ(evidence().cut_off, 0) << "a change that does not look like it";
  object_like_(cv::Rect(kObject.br().x, kObject.y, 10, kObject.height)).setTo(255);
  EXPECT_NEAR(evidence().cut_off, kObject.height / 96., 0.07) << "one side of the outline";
  region_ = kRegion;
  EXPECT_EQ(evidence().cut_off, 0) << "beside it in the region";
  intruders_ = map_of({kObject.x, kObject.br().y + 1, kObject.width, 5});
  EXPECT_NEAR(evidence().cut_off, kObject.width / 96., 0.07) << "it may lie below an intruder";
}

TEST_F(CutEvidenceTest, BoundaryContrastGrowsAsTheOutlineCostFalls) {
  prefer(8, -8);
  EXPECT_NEAR(evidence().boundary_contrast, 0, 1e-6);
  for (auto& weights : smoothness_.weights) weights *= 0.25;
  EXPECT_NEAR(evidence().boundary_contrast, 0.75, 1e-6);
}

TEST(MapMeasures, TheOutlineIsTheOutermostPixels) {
  EXPECT_EQ(cv::countNonZero(outline_pixels(map_of({20, 20, 10, 8}))), 2 * 10 + 2 * 8 - 4);
  EXPECT_EQ(cv::countNonZero(outline_pixels(map_of({0, 0, 80, 60}))), 2 * 80 + 2 * 60 - 4);
}

TEST(MapMeasures, DetectContactWithEveryBorder) {
  EXPECT_FALSE(touches_border(map_of({1, 1, 78, 58})));
  for (const cv::Rect& place :
       {cv::Rect(0, 20, 5, 5), {75, 20, 5, 5}, {20, 0, 5, 5}, {20, 55, 5, 5}})
    EXPECT_TRUE(touches_border(map_of(place))) << place;
}

}  // namespace
}  // namespace mbncc::segmentation
