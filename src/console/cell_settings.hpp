// SPDX-License-Identifier: BSD-3-Clause
// Settings of the cell that the console reads from the parameter server.
#pragma once

#include <map>
#include <string>

namespace mbncc::console {

/// The camera's own images.
struct CellImages {
  std::string cell;     ///< namespace
  std::string topic;    ///< their resolved topic name
  int white_level = 0;  ///< as the matching nodelet's; 0: none
};

struct Thresholds {
  double min_score = 0.5, confirm_score = 0.7;  ///< of the matcher
  std::map<std::string, double> own{};          ///< min_score of the objects that have their own

  double min_score_of(const std::string& object) const {
    const auto found = own.find(object);
    return found == own.end() ? min_score : found->second;
  }
};

}  // namespace mbncc::console
