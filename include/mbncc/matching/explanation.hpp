// SPDX-License-Identifier: BSD-3-Clause
// Why objects are found at a place of a picture, or are not.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// One part of the evidence at a pose.
struct ScorePart {
  std::string name;
  double value = 0;
  double lacking = 0;  ///< log-odds that it would add were it perfect
};

/// A threshold that a search applies.
struct Check {
  std::string name;  ///< the parameter
  double value = 0, threshold = 0;
  bool passed = false;
  bool to_report = false;  ///< without it nothing is reported; else it must not be grasped
};

/// What the search makes of one object about one place.
struct Explanation {
  enum class Outcome {
    kGraspable,
    kReported,    ///< but must not be grasped
    kRejected,    ///< proposed by the search, and not reported
    kNotProposed  ///< the search's first steps pass over the place; judged there all the same
  };

  std::string name;
  Outcome outcome = Outcome::kNotProposed;
  Pose2D pose;       ///< [px],[rad] the best one about the place
  double scale = 1;  ///< relative to the learning picture
  double score = 0;  ///< [0..1]; of what was not proposed: before it is compared with others
  double log_odds = 0;
  std::vector<cv::Point2f> outline;  ///< [px]
  std::vector<ScorePart> parts;      ///< empty with the engine polar
  double evidence = 0;               ///< log-odds of all parts together
  double clutter = 0;                ///< log-odds taken off for look-alikes elsewhere
  std::vector<Check> checks;
  std::vector<std::string> reasons;     ///< against grasping, the most important first
  std::vector<Competitor> competitors;  ///< as of Match
  std::string covered_by;               ///< the better object that takes the place; "": none does

  /// log_odds = evidence - clutter + rest(): colours of parts, mirror image, other rotations,
  /// calibration.
  double rest() const { return log_odds - evidence + clutter; }
};

/// What a search for all of `objects` that are enabled makes of `place` [px] in `picture`, the most
/// likely first; of `names` alone, where there are any. Throws std::invalid_argument like
/// Matcher::find(), for a place outside the picture, and for a name that is unknown or disabled.
std::vector<Explanation> explain_place(
    const std::vector<std::shared_ptr<const ObjectModel>>& objects, const SearchConfig& config,
    const cv::Mat& picture, cv::Point2d place, const std::vector<std::string>& names = {});

/// Sentences, the verdict first, what to do about it last; a line each.
std::vector<std::string> lines_of(const Explanation& explanation);

/// CV_8UC3 copy of `picture` with the place, the best pose of the first explanation and its rivals.
cv::Mat draw_explanation(const cv::Mat& picture, cv::Point2d place,
                         const std::vector<Explanation>& explanations);

}  // namespace mbncc
