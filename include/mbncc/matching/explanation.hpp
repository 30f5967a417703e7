// SPDX-License-Identifier: BSD-3-Clause
// Explains why an object is or is not found at a place in an image.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// One term of the score at a pose.
struct ScorePart {
  std::string name;
  double value = 0;
  double lacking = 0;  ///< log-odds that a perfect value would add
};

/// A threshold of the search.
struct Check {
  std::string name;  ///< the parameter
  double value = 0, threshold = 0;
  bool passed = false;
  bool to_report = false;  ///< true: needed to report a match; false: needed to grasp it
};

/// Result of the search for one object near one place.
struct Explanation {
  enum class Outcome {
    kGraspable,
    kReported,    ///< found but not graspable
    kRejected,    ///< proposed by the search but not reported
    kNotProposed  ///< not proposed by the search; verified at the place anyway
  };

  std::string name;
  Outcome outcome = Outcome::kNotProposed;
  Pose2D pose;       ///< [px],[rad] best pose near the place
  double scale = 1;  ///< relative to the learning image
  double score = 0;  ///< [0..1]; if kNotProposed: before the comparison with other detections
  LogOdds odds;
  std::vector<cv::Point2f> outline;  ///< [px]
  std::vector<ScorePart> parts;      ///< empty with the engine polar
  std::vector<Check> checks;
  std::vector<std::string> reasons;     ///< reasons against grasping, the most important first
  std::vector<Competitor> competitors;  ///< see Match::competitors
  std::string covered_by;               ///< another object whose match covers the place; "": none
};

/// Explains the result at `place` [px] of a search for all enabled `objects` in `image`: one
/// explanation per enabled object that can be searched for, or per name if `names` is not empty,
/// most likely first. Throws std::invalid_argument like Matcher::find(), and if the place is
/// outside the image or a name is unknown, disabled or cannot be searched for.
std::vector<Explanation> explain_place(
    const std::vector<std::shared_ptr<const ObjectModel>>& objects, const SearchConfig& config,
    const cv::Mat& image, cv::Point2d place, const std::vector<std::string>& names = {});

/// The explanation in sentences, one per element: the result first, the remedy last.
std::vector<std::string> lines_of(const Explanation& explanation);

/// CV_8UC3 copy of `image` with the place, the best pose of the first explanation and its
/// competitors.
cv::Mat draw_explanation(const cv::Mat& image, cv::Point2d place,
                         const std::vector<Explanation>& explanations);

}  // namespace mbncc
