// SPDX-License-Identifier: BSD-3-Clause
// Prints detections in one of three formats.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <ostream>
#include <string>

#include "mbncc/matching/matcher.hpp"

namespace mbncc::cli {

class MatchReport {
 public:
  virtual ~MatchReport() = default;

  /// `image` is the path as given on the command line.
  virtual void add(const std::string& image, const cv::Size& size, const SearchResult& result) = 0;
};

/// A header, then one row per detection; an image without detections gets a row with empty fields.
std::unique_ptr<MatchReport> csv_report(std::ostream& out);

/// One JSON object per image, each on its own line.
std::unique_ptr<MatchReport> json_report(std::ostream& out);

/// Human-readable lines.
std::unique_ptr<MatchReport> plain_report(std::ostream& out);

}  // namespace mbncc::cli
