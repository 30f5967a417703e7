// SPDX-License-Identifier: BSD-3-Clause
// Reads comma-separated files whose first line names the columns; no quoting.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace mbncc::bench {

using CsvRow = std::map<std::string, std::string>;

/// All rows of a file. Throws std::runtime_error if it cannot be read or a row has the wrong number
/// of columns.
std::vector<CsvRow> read_csv(const std::string& path);

/// "a;b;c" -> {a, b, c}; empty parts are dropped.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace mbncc::bench
