// SPDX-License-Identifier: BSD-3-Clause
// Tables in Markdown and CSV.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace mbncc::bench {

struct Table {
  std::vector<std::string> columns;
  std::vector<std::vector<std::string>> rows;
};

/// Fixed number of decimals; "-" for NaN and infinity.
std::string to_text(double value, int decimals);

void write_markdown(std::ostream& out, const Table& table);
void write_csv(std::ostream& out, const Table& table);

/// Throws std::runtime_error if the file cannot be written.
void save_csv(const std::string& path, const Table& table);

}  // namespace mbncc::bench
