// SPDX-License-Identifier: BSD-3-Clause
// Explains why objects are found at a place in an image or not.
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
  double lacking = 0;  ///< largest log-odds that it can add
};

/// A threshold of the search.
struct Check {
  std::string name;  ///< the parameter
  double value = 0, threshold = 0;
  bool passed = false;
  bool to_report =
      false;  ///< if it fails, nothing is reported; otherwise the match is not graspable
};

/// Result of the search for one object near one place.
struct Explanation {
  enum class Outcome {
    kGraspable,
    kReported,    ///< found but not graspable
    kRejected,    ///< proposed by the search, and not reported
    kNotProposed  ///< the proposals of the search miss the place; verified there nevertheless
  };

  std::string name;
  Outcome outcome = Outcome::kNotProposed;
  Pose2D pose;       ///< [px],[rad] the best one near the place
  double scale = 1;  ///< relative to the learning image
  double score = 0;  ///< [0..1]; if it was not proposed: before the comparison with others
  LogOdds odds;
  std::vector<cv::Point2f> outline;  ///< [px]
  std::vector<ScorePart> parts;      ///< empty with the engine polar
  std::vector<Check> checks;
  std::vector<std::string> reasons;     ///< reasons against grasping, the most important first
  std::vector<Competitor> competitors;  ///< as of Match
  std::string covered_by;               ///< the object with a higher score at the place; "": none
};

/// Explains `place` [px] in `image` for a search of all enabled `objects`, the most likely first;
/// only those of `names`, if there are any. Throws std::invalid_argument like Matcher::find(), for
/// a place outside the image, and for a name that is unknown or disabled.
std::vector<Explanation> explain_place(
    const std::vector<std::shared_ptr<const ObjectModel>>& objects, const SearchConfig& config,
    const cv::Mat& image, cv::Point2d place, const std::vector<std::string>& names = {});

/// Sentences, one per line: the result first, the remedy last.
std::vector<std::string> lines_of(const Explanation& explanation);

/// CV_8UC3 copy of `image` with the place, the best pose of the first explanation and its
/// competitors.
cv::Mat draw_explanation(const cv::Mat& image, cv::Point2d place,
                         const std::vector<Explanation>& explanations);

}  // namespace mbncc
