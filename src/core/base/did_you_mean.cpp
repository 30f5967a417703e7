// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/did_you_mean.hpp"

#include <algorithm>
#include <numeric>

namespace mbncc {
namespace {

// Levenshtein distance, computed row by row.
int edit_distance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
  std::string nearest;
  int fewest = 2 + static_cast<int>(word.size()) / 4;  // more than a typing error changes
  for (const auto& candidate : known) {
    const int edits = edit_distance(candidate, word);
    if (edits >= fewest) continue;
    fewest = edits;
    nearest = candidate;
  }
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace mbncc
