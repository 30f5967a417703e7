// SPDX-License-Identifier: BSD-3-Clause
// What a watched scene is known to show and what is still owed to it, between pictures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cell/incremental_search/instance_list.hpp"
#include "cell/incremental_search/object_schedule.hpp"
#include "cell/incremental_search/pending_regions.hpp"
#include "mbncc/cell/change_map.hpp"

namespace mbncc {

struct SearchMemory {
  SearchMemory(const SearchRequest& asked, const SearchConfig& config)
      : request(asked), sought(asked.names), known(config.max_overlap) {}

  /// All of one object but that it is sought.
  void forget(const std::string& name);

  SearchRequest request;
  ChangeMap changes;
  ObjectSchedule sought;
  InstanceList known;
  std::vector<Known> hidden;  ///< gone from where they were while that was still changing
  PendingRegions debts;
  std::map<std::string, double> clutter;  ///< by name, of the whole picture
  double last_sweep = 0;                  ///< [s]
};

/// What a picture shows by all that is known: at most request.max_instances (0: config's) per name,
/// best first.
SearchResult report_of(const SearchMemory& memory, const SearchConfig& config,
                       bool budget_exceeded);

}  // namespace mbncc
