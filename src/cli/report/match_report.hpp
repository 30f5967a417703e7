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

  /// `image` as given on the command line.
  virtual void add(const std::string& image, const cv::Size& size, const SearchResult& result) = 0;
};

/// Header, then a row per detection, or one with empty fields for an image without any.
std::unique_ptr<MatchReport> csv_report(std::ostream& out);

/// One line per image, each an object.
std::unique_ptr<MatchReport> json_report(std::ostream& out);

/// Lines for people.
std::unique_ptr<MatchReport> plain_report(std::ostream& out);

}  // namespace mbncc::cli
