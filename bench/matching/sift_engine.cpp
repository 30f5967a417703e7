// SPDX-License-Identifier: BSD-3-Clause
#include "matching/sift_engine.hpp"

#include <cmath>
#include <opencv2/calib3d.hpp>

namespace mbncc::bench {
namespace {

constexpr float kRatio = 0.8F;            // Lowe's ratio test
constexpr double kReprojection = 3;       // [px]
constexpr std::size_t kLeastInliers = 3;  // two points determine a similarity transform
constexpr int kMostInstances = 10;
constexpr double kScaleRange = 1.2;  // the camera is fixed, so other scales are certainly wrong

struct Pairs {
  std::vector<cv::Point2f> learned, seen;
};

Pairs unexplained(const Pairs& pairs, const cv::Mat& inliers) {
  Pairs rest;
  for (int i = 0; i < inliers.rows; ++i) {
    if (inliers.at<uchar>(i) != 0) continue;
    rest.learned.push_back(pairs.learned[static_cast<std::size_t>(i)]);
    rest.seen.push_back(pairs.seen[static_cast<std::size_t>(i)]);
  }
  return rest;
}

}  // namespace

SiftEngine::SiftEngine() : sift_(cv::SIFT::create()) {}

void SiftEngine::teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) {
  sift_->detectAndCompute(image, map, points_, descriptors_);
  reference_ = reference;
}

std::vector<Found> SiftEngine::find(const cv::Mat& image) {
  std::vector<cv::KeyPoint> seen;
  cv::Mat descriptors;
  sift_->detectAndCompute(image, cv::noArray(), seen, descriptors);
  if (points_.size() < 2 || seen.empty()) return {};
  // Matches from the image to the object, so that several instances can use the same learned point.
  std::vector<std::vector<cv::DMatch>> matches;
  cv::BFMatcher(cv::NORM_L2).knnMatch(descriptors, descriptors_, matches, 2);
  Pairs pairs;
  for (const auto& match : matches) {
    if (match.size() < 2 || match[0].distance > kRatio * match[1].distance) continue;
    pairs.learned.push_back(points_[static_cast<std::size_t>(match[0].trainIdx)].pt);
    pairs.seen.push_back(seen[static_cast<std::size_t>(match[0].queryIdx)].pt);
  }
  std::vector<Found> found;
  for (int i = 0; i < kMostInstances && pairs.learned.size() >= kLeastInliers; ++i) {
    cv::Mat inliers;
    const cv::Mat transform =
        cv::estimateAffinePartial2D(pairs.learned, pairs.seen, inliers, cv::RANSAC, kReprojection);
    const int count = inliers.empty() ? 0 : cv::countNonZero(inliers);
    if (transform.empty() || count < static_cast<int>(kLeastInliers)) break;
    pairs = unexplained(pairs, inliers);
    const cv::Matx23d m = transform;
    const double scale = std::hypot(m(0, 0), m(1, 0));
    if (scale > kScaleRange || scale < 1 / kScaleRange) continue;
    const cv::Point2d at = m * cv::Vec3d(reference_.x, reference_.y, 1);
    found.push_back(
        {{at.x, at.y, std::atan2(m(1, 0), m(0, 0))}, static_cast<double>(count), false, {}});
  }
  return found;
}

}  // namespace mbncc::bench
