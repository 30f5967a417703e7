// SPDX-License-Identifier: BSD-3-Clause
// Detections of one case as a file, for scoring by another program.
#pragma once

#include <filesystem>
#include <string>

#include "common/table.hpp"
#include "matching/engine.hpp"

namespace mbncc::bench {

/// A row per detection; a row with empty fields for a target without any.
class Predictions {
 public:
  void add(const std::string& target, const std::vector<Found>& found, double ms);

  /// Writes folder/<case>.csv. Throws std::runtime_error when that fails.
  void save(const std::filesystem::path& folder, const std::string& name) const;

 private:
  Table table_{{"target", "x", "y", "theta_deg", "score", "ms"}, {}};
};

}  // namespace mbncc::bench
