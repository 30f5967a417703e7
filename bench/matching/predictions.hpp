// SPDX-License-Identifier: BSD-3-Clause
// Writes the detections of one case to a file, so that another program can score them.
#pragma once

#include <filesystem>
#include <string>

#include "common/table.hpp"
#include "matching/engine.hpp"

namespace mbncc::bench {

/// One row per detection; a target without detections gets a row with empty fields.
class Predictions {
 public:
  void add(const std::string& target, const std::vector<Found>& found, double ms);

  /// Writes folder/<case>.csv. Throws std::runtime_error on failure.
  void save(const std::filesystem::path& folder, const std::string& name) const;

 private:
  Table table_{{"target", "x", "y", "theta_deg", "score", "ms"}, {}};
};

}  // namespace mbncc::bench
