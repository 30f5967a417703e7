// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/search_memory.hpp"

#include <algorithm>
#include <utility>

#include "matching/decision/report.hpp"

namespace mbncc::incremental_search {

void SearchMemory::forget(const std::string& name) {
  pending.forget(name);
  clutter.erase(name);
  const auto is_it = [&](const Instance& one) { return one.match.name == name; };
  instances.take(is_it);
  hidden.erase(std::remove_if(hidden.begin(), hidden.end(), is_it), hidden.end());
}

SearchResult report_of(const SearchMemory& memory, const SearchConfig& config,
                       bool budget_exceeded) {
  const std::vector<std::string> names = memory.objects.names();
  SearchResult result;
  for (const auto& name : names)
    if (memory.pending.contains(name))
      result.skipped.push_back(name + ": not yet searched where the image changed");
    else
      result.searched.push_back(name);
  for (auto& reason : memory.objects.unavailable()) result.skipped.push_back(std::move(reason));
  for (const auto& instance : memory.instances.all())
    result.matches.push_back(instance.judged(names, config));
  const int asked = memory.request.max_instances;
  const int most = asked > 0 ? asked : config.max_instances;
  result.matches = decision::reported(std::move(result.matches), memory.request.roi, most, config);
  result.limited = names_at_limit(result.matches, most);
  result.budget_exceeded = budget_exceeded;
  return result;
}

}  // namespace mbncc::incremental_search
