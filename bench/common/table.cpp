// SPDX-License-Identifier: BSD-3-Clause
#include "common/table.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <sstream>
#include <stdexcept>

namespace mbncc::bench {
namespace {

using Cells = std::vector<std::string>;

std::vector<std::size_t> widths_of(const Table& table) {
  std::vector<std::size_t> widths;
  for (const auto& name : table.columns) widths.push_back(name.size());
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  return widths;
}

void write_row(std::ostream& out, const Cells& cells, const std::vector<std::size_t>& widths) {
  for (std::size_t i = 0; i < cells.size(); ++i)
    out << "| " << std::setw(static_cast<int>(widths[i])) << (i == 0 ? std::left : std::right)
        << cells[i] << ' ';
  out << "|\n";
}

}  // namespace

std::string to_text(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  std::ostringstream text;
  text << std::fixed << std::setprecision(decimals) << value;
  return text.str();
}

void write_markdown(std::ostream& out, const Table& table) {
  const auto widths = widths_of(table);
  write_row(out, table.columns, widths);
  for (std::size_t i = 0; i < widths.size(); ++i)
    out << '|' << std::string(widths[i] + 1, '-') << (i == 0 ? '-' : ':');
  out << "|\n";
  for (const auto& row : table.rows) write_row(out, row, widths);
}

void write_csv(std::ostream& out, const Table& table) {
  const auto write = [&](const Cells& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) out << (i == 0 ? "" : ",") << cells[i];
    out << '\n';
  };
  write(table.columns);
  for (const auto& row : table.rows) write(row);
}

void save_csv(const std::string& path, const Table& table) {
  std::ofstream file(path);
  write_csv(file, table);
  if (!file.flush()) throw std::runtime_error("cannot write '" + path + "'");
}

}  // namespace mbncc::bench
