// SPDX-License-Identifier: BSD-3-Clause
#include "matching/predictions.hpp"

namespace mbncc::bench {

void Predictions::add(const std::string& target, const std::vector<Found>& found, double ms) {
  if (found.empty()) table_.rows.push_back({target, "", "", "", "", to_text(ms, 4)});
  for (const auto& one : found)
    table_.rows.push_back({target, to_text(one.pose.x, 5), to_text(one.pose.y, 5),
                           to_text(to_degrees(one.pose.theta), 5), to_text(one.score, 9),
                           to_text(ms, 4)});
}

void Predictions::save(const std::filesystem::path& folder, const std::string& name) const {
  std::filesystem::create_directories(folder);
  save_csv((folder / (name + ".csv")).string(), table_);
}

}  // namespace mbncc::bench
