// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/library/library_snapshot.hpp"

#include <algorithm>

namespace mbncc {

std::shared_ptr<const ObjectModel> LibrarySnapshot::find(const std::string& name) const {
  const auto found = std::find_if(objects.begin(), objects.end(),
                                  [&name](const auto& object) { return object->name == name; });
  return found == objects.end() ? nullptr : *found;
}

}  // namespace mbncc
