// SPDX-License-Identifier: BSD-3-Clause
// Rotational symmetry that an operator declares for an object.
#pragma once

#include <optional>
#include <string>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// Number of equal angles in a turn that may be declared: 1 (none), 2 to 12, or 0 (round).
bool is_declarable_symmetry(int symmetry);

/// "none", "2" to "12" or "round"; "auto" if nothing is declared and the symmetry is measured.
std::string symmetry_text(std::optional<int> symmetry);

/// Inverse of symmetry_text(). Throws std::invalid_argument that lists the allowed words.
std::optional<int> parse_symmetry(const std::string& text);

/// Sets or clears the declared symmetry. A declaration removes the lesson's proposals, the reasons
/// nearly_..., from the object's quality. Throws std::invalid_argument for values that may not be
/// declared.
void declare_symmetry(ObjectModel& model, std::optional<int> symmetry);

}  // namespace mbncc
