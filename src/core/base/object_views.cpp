// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/object_views.hpp"

#include <stdexcept>
#include <string>

namespace mbncc {

void remove_view(ObjectModel& model, std::size_t number) {
  const std::size_t count = model.views.size();
  if (number < 1 || number > count)
    throw std::invalid_argument(
        "there is no view " + std::to_string(number) +
        (count == 1 ? "; it has one view" : "; its views are 1 to " + std::to_string(count)));
  if (count == 1)
    throw std::invalid_argument(
        "the only view of an object cannot be removed; delete the object instead");
  model.views.erase(model.views.begin() + static_cast<std::ptrdiff_t>(number - 1));
}

}  // namespace mbncc
