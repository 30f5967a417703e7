// SPDX-License-Identifier: BSD-3-Clause
// State of the video search between images: known instances and pending searches.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cell/incremental_search/instance_list.hpp"
#include "cell/incremental_search/object_schedule.hpp"
#include "cell/incremental_search/pending_regions.hpp"
#include "mbncc/cell/change_map.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::incremental_search {

struct SearchMemory {
  SearchMemory(const SearchRequest& asked, const SearchConfig& config)
      : request(asked), objects(asked.names), instances(config.max_overlap) {}

  /// Drops all data of one object, which stays in the schedule.
  void forget(const std::string& name);

  SearchRequest request;
  ChangeMap changes;
  ObjectSchedule objects;
  InstanceList instances;
  std::vector<Instance> hidden;  ///< not found while their places were still changing
  PendingRegions pending;
  std::map<std::string, double> clutter;  ///< by name, SearchResult::clutter of the whole image
  double last_sweep = 0;                  ///< [s] stamp of the last search of the whole image
};

/// The result for an image from the known instances: those in request.roi, at most
/// request.max_instances (0: config's) per name, best first.
SearchResult report_of(const SearchMemory& memory, const SearchConfig& config,
                       bool budget_exceeded);

}  // namespace mbncc::incremental_search
