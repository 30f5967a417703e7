// SPDX-License-Identifier: BSD-3-Clause
#include "cell/incremental_search/search_memory.hpp"

#include <algorithm>

namespace mbncc::incremental_search {
namespace {

void keep_best(int most, std::vector<Match>& matches) {
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& a, const Match& b) { return a.score > b.score; });
  std::map<std::string, int> count;
  matches.erase(std::remove_if(matches.begin(), matches.end(),
                               [&](const Match& match) { return ++count[match.name] > most; }),
                matches.end());
}

}  // namespace

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
  keep_best(most, result.matches);
  result.limited = names_at_limit(result.matches, most);
  result.budget_exceeded = budget_exceeded;
  return result;
}

}  // namespace mbncc::incremental_search
