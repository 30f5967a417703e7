// SPDX-License-Identifier: BSD-3-Clause
// What the searches within a lesson have in common.
#pragma once

#include <memory>

#include "mbncc/config/search_config.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::quality {

/// `search` without a time budget, because a verdict must not depend on the machine's load.
SearchConfig without_time_budget(SearchConfig search);

/// A copy of `object` without grasp whose reference point is the centroid of its first map, because
/// the object frame may lie far from the object.
std::shared_ptr<ObjectModel> with_central_reference(const ObjectModel& object);

}  // namespace mbncc::quality
