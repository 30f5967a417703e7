// SPDX-License-Identifier: BSD-3-Clause
// The package's own matcher, with its shipped threshold.
#pragma once

#include "matching/engine.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::bench {

class MbnccEngine : public Engine {
 public:
  void teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) override;
  std::vector<Found> find(const cv::Mat& image) override;
  std::optional<double> threshold() const override { return matcher_.config().min_score; }

 private:
  Matcher matcher_;
};

}  // namespace mbncc::bench
