// SPDX-License-Identifier: BSD-3-Clause
// The numbers of a quality in one list, which is used for writing and reading.
#pragma once

#include "mbncc/object_model.hpp"

namespace mbncc::library {

/// Calls visit(key, value, lowest, highest) for each number.
template <class SomeQuality, class Visitor>
void for_each_number(SomeQuality& quality, Visitor&& visit) {
  visit("area", quality.area, 0.0, 1e9);
  visit("fill", quality.fill, 0.0, 1.5);
  visit("contrast", quality.contrast, 0.0, 255.0);
  visit("edge_agreement", quality.edge_agreement, 0.0, 1.0);
  visit("change_agreement", quality.change_agreement, 0.0, 1.0);
  visit("outline_probability", quality.outline_probability, 0.0, 1.0);
  visit("self_score", quality.self_score, 0.0, 1.0);
  visit("self_error", quality.self_error, 0.0, 1e9);
  visit("runner_up", quality.runner_up, 0.0, 1.0);
  visit("angle_halfwidth", quality.angle_halfwidth, 0.0, 2 * kPi);
  visit("confusable_score", quality.confusable_score, 0.0, 1.0);
  visit("search_time", quality.search_time, 0.0, 1e9);
}

}  // namespace mbncc::library
