// SPDX-License-Identifier: BSD-3-Clause
// Reduces what a search has found to the objects that a caller asks for by name. All objects are
// searched nevertheless, so that look-alikes compete.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mbncc/library/library_snapshot.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {

/// Removes the items whose `name_of(item)` is not in `names`; none if `names` is empty.
template <class Item, class NameOf>
void erase_others(const std::vector<std::string>& names, std::vector<Item>& items,
                  const NameOf& name_of) {
  if (names.empty()) return;
  const auto is_other = [&](const Item& item) {
    return std::find(names.begin(), names.end(), name_of(item)) == names.end();
  };
  items.erase(std::remove_if(items.begin(), items.end(), is_other), items.end());
}

/// Removes what concerns objects that are not in `names`, and adds the named ones that `library`
/// lacks or has disabled to `skipped`. Changes nothing if `names` is empty.
void keep_named(const std::vector<std::string>& names, const LibrarySnapshot& library,
                SearchResult& result);

}  // namespace mbncc
