// SPDX-License-Identifier: BSD-3-Clause
// Detections of an object for tests of what is decided about them.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <vector>

#include "matching/decision/selection.hpp"
#include "matching/images.hpp"
#include "matching/prepared/prepared_object.hpp"

namespace mbncc::test {

class DecisionTest : public ::testing::Test {
 protected:
  const LearningImage source_{1};
  const prepared::PreparedObject object_{object_from(source_, {58, 60, 0}),
                                         prepared::Engine::kFast};
  const prepared::PreparedObject other_{object_from(source_, {58, 60, 0}, "other"),
                                        prepared::Engine::kFast};
  const SearchConfig config_{};

  /// A reliable detection with a distinct outline, accurate to a tenth of a pixel.
  decision::Detection sound() const {
    decision::Detection detection;
    detection.object = object_.model.get();
    detection.view = &object_.views.front();
    detection.pose = {100, 100, 0};
    detection.covariance = detection.grasp_covariance = cv::Matx33d::diag({0.01, 0.01, 1e-6});
    detection.odds.best_at_place = 20;
    detection.contour_alternative = -0.15;
    detection.print_difference = detection.edge_difference = detection.detail_difference = 0;
    return detection;
  }

  decision::Detection changed(const std::function<void(decision::Detection&)>& change) const {
    decision::Detection detection = sound();
    change(detection);
    return detection;
  }

  static decision::Selection select(const std::vector<decision::Detection>& detections,
                                    const SearchConfig& config, std::optional<double> min_score,
                                    int max_instances) {
    return decision::select_matches(detections, {config, min_score, max_instances, {}, {}, 0});
  }

  decision::Selection select(const std::vector<decision::Detection>& detections,
                             std::optional<double> min_score = std::nullopt,
                             int max_instances = 10) const {
    return select(detections, config_, min_score, max_instances);
  }

  /// The match from the only detection in an image.
  Match match_of(const decision::Detection& detection) const {
    return select({detection}).matches.at(0);
  }
};

}  // namespace mbncc::test
