// SPDX-License-Identifier: BSD-3-Clause
// The other tool at hand in OpenCV: SIFT points under the map, matched, RANSAC for shift and turn.
#pragma once

#include <opencv2/features2d.hpp>
#include <vector>

#include "matching/engine.hpp"

namespace mbncc::bench {

/// Scores are counts of inliers.
class SiftEngine : public Engine {
 public:
  SiftEngine();

  void teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) override;
  std::vector<Found> find(const cv::Mat& image) override;

 private:
  cv::Ptr<cv::SIFT> sift_;
  std::vector<cv::KeyPoint> points_;
  cv::Mat descriptors_;
  cv::Point2d reference_;
};

}  // namespace mbncc::bench
