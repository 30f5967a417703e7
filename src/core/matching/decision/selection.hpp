// SPDX-License-Identifier: BSD-3-Clause
// Selects matches from refined poses.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "matching/decision/detection.hpp"
#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/match.hpp"

namespace mbncc::decision {

/// Thresholds of one call.
struct AcceptanceSettings {
  const SearchConfig& config;
  std::optional<double> min_score;  ///< for all objects; empty: the object's or config's
  int max_instances;                ///< per name
  std::map<std::string, double> clutter, elsewhere;  ///< see SearchRequest
  std::size_t objects = 1;                           ///< number of objects searched in the image
  /// [px] Only instances whose reference points lie in it are reported; other angles and objects
  /// outside compete with them. Empty: all.
  cv::Rect part = {};
};

struct Selection {
  std::vector<Match> matches;  ///< best score first
  std::vector<Rival> rivals;   ///< see SearchResult
  std::map<std::string, double> clutter;
};

/// The value compared with the thresholds [0..1]: the score, or the similarity if accept_by is
/// similarity.
double acceptance_score(const Detection& detection, const SearchConfig& config);

/// Accepts the best detections of all objects that do not overlap a better one, measures their
/// margins to the others, and converts them to matches.
Selection select_matches(std::vector<Detection> detections, const AcceptanceSettings& acceptance);

}  // namespace mbncc::decision
