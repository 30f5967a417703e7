// SPDX-License-Identifier: BSD-3-Clause
// The other common solution with OpenCV: SIFT points under the map, matching, and RANSAC for shift
// and rotation.
#pragma once

#include <opencv2/features2d.hpp>
#include <vector>

#include "matching/engine.hpp"

namespace mbncc::bench {

/// The score is the number of inliers.
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
