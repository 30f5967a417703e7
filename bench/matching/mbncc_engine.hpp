// The package's own matcher.
#pragma once

#include "matching/engine.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::bench {

class MbnccEngine : public Engine {
 public:
  /// With a `floor` everything scoring more is reported and no shipped threshold counts.
  explicit MbnccEngine(SearchConfig config, std::optional<double> floor = {});

  void teach(const cv::Mat& picture, const cv::Mat& map, cv::Point2d reference) override;
  std::vector<Found> find(const cv::Mat& picture) override;
  std::optional<double> threshold() const override;

 private:
  std::optional<double> floor_;
  Matcher matcher_;
};

}  // namespace mbncc::bench
