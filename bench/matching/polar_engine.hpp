// SPDX-License-Identifier: BSD-3-Clause
// The paper's matching (MB-NCC in the polar domain) and its baseline: PP-NCC, the same search with
// all pixels of the incircle or excircle (doi 10.1177/1687814017728839).
#pragma once

#include <optional>

#include "matching/engine.hpp"
#include "mbncc/matching/polar_search.hpp"

namespace mbncc::bench {

/// Scores are similarities.
class PolarEngine : public Engine {
 public:
  explicit PolarEngine(PolarRegion region) : region_(region) {}

  void teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) override;
  std::vector<Found> find(const cv::Mat& image) override;

 private:
  PolarRegion region_;
  std::optional<PolarSearch> search_;
  cv::Point2d lever_;  // reference point relative to the centre of the search
  double apart_ = 0;   // [px] minimum distance of two detections
};

}  // namespace mbncc::bench
