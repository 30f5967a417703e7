// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/matching/named_objects.hpp"

#include <set>

namespace mbncc {

void keep_named(const std::vector<std::string>& names, const LibrarySnapshot& library,
                SearchResult& result) {
  const auto itself = [](const std::string& name) { return name; };
  erase_others(names, result.matches, [](const Match& match) { return match.name; });
  erase_others(names, result.searched, itself);
  erase_others(names, result.limited, itself);
  erase_others(names, result.skipped,
               [](const std::string& reason) { return reason.substr(0, reason.find(':')); });
  for (const auto& name : std::set<std::string>(names.begin(), names.end())) {
    const auto known = library.find(name);
    if (!known) result.skipped.push_back(name + ": unknown");
    if (known && !known->enabled) result.skipped.push_back(name + ": disabled");
  }
}

}  // namespace mbncc
