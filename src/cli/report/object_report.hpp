// SPDX-License-Identifier: BSD-3-Clause
// Prints a learned object as text and as JSON.
#pragma once

#include <ostream>
#include <string>

#include "cli/report/json_writer.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc::cli {

/// "2026-11-21 02:30:00 UTC", or "unknown" for 0.
std::string time_text(double seconds_since_1970);

void write_quality(JsonWriter& json, const Quality& quality);
void write_object(JsonWriter& json, const ObjectModel& object);
void print_object(std::ostream& out, const ObjectModel& object);

}  // namespace mbncc::cli
