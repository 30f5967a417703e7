// SPDX-License-Identifier: BSD-3-Clause
#include "cli/evaluate/truth.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "mbncc/did_you_mean.hpp"
#include "mbncc/error.hpp"
#include "mbncc/utf8.hpp"

namespace mbncc::cli {
namespace {

/// The cells of a line of CSV (RFC 4180), except that none may contain a line break.
std::vector<std::string> cells_of(std::string line) {
  if (!line.empty() && line.back() == '\r') line.pop_back();
  if (line.empty()) return {};
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool escaped = quoted && line.compare(i, 2, "\"\"") == 0;
    if (escaped)
      cells.back() += line[i++];
    else if (line[i] == '"')
      quoted = !quoted;
    else if (line[i] == ',' && !quoted)
      cells.emplace_back();
    else
      cells.back() += line[i];
  }
  while (!cells.empty() && cells.back().empty()) cells.pop_back();
  return cells;
}

std::string without_byte_order_mark(const std::string& text) {
  constexpr const char* kMark = "\xEF\xBB\xBF";
  return text.rfind(kMark, 0) == 0 ? text.substr(3) : text;
}

const std::vector<std::string> kColumns = {"image", "name", "x", "y", "theta_deg"};

bool is_text(std::string_view line) {
  while (const std::size_t length = utf8_length(line)) line.remove_prefix(length);
  return line.empty();
}

class Columns {
 public:
  Columns(const std::string& path, const std::vector<std::string>& header) : path_(path) {
    for (std::size_t i = 0; i < header.size(); ++i) {
      if (std::find(kColumns.begin(), kColumns.end(), header[i]) == kColumns.end())
        throw FileError(path, "its column '" + header[i] + "' is unknown" +
                                  did_you_mean(header[i], kColumns) +
                                  "; give image,name,x,y,theta_deg");
      places_[header[i]] = i;
    }
    for (const char* needed : {"image", "x", "y"})
      if (places_.count(needed) == 0)
        throw FileError(path, std::string("its first line has no column '") + needed +
                                  "'; give image,name,x,y,theta_deg");
  }

  std::string text(const std::vector<std::string>& row, const std::string& name) const {
    const auto at = places_.find(name);
    return at == places_.end() || at->second >= row.size() ? "" : row[at->second];
  }

  double number(const std::vector<std::string>& row, const std::string& name, int line) const {
    const std::string value = text(row, name);
    // An angle that was taken to be 0 would make right detections wrong.
    if (value.empty() && name == "theta_deg")
      throw FileError(path_, "line " + std::to_string(line) +
                                 " has no theta_deg; give the angle in degrees, 0 for a round "
                                 "object");
    try {
      std::size_t used = 0;
      const double number = std::stod(value, &used);
      if (used == value.size() && std::isfinite(number)) return number;
    } catch (const std::exception&) {
    }
    throw FileError(
        path_, "line " + std::to_string(line) + ": " + name + " is not a number: '" + value + "'");
  }

 private:
  std::string path_;
  std::map<std::string, std::size_t> places_;
};

}  // namespace

Truth::const_iterator entry_of(const Truth& truth, const std::string& image_path) {
  const auto path = std::filesystem::absolute(image_path).lexically_normal();
  for (auto first = path.begin(); first != path.end(); ++first) {
    std::filesystem::path rest;
    for (auto part = first; part != path.end(); ++part) rest /= *part;
    const auto entry = truth.find(rest.string());
    if (entry != truth.end()) return entry;
  }
  return truth.end();
}

Truth read_truth(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!file || !std::getline(file, line)) throw FileError(path, "cannot be read, or is empty");
  if (!is_text(line))
    throw FileError(path,
                    "not a text file; give a CSV file with the columns image,name,x,y,theta_deg");
  const Columns columns(path, cells_of(without_byte_order_mark(line)));
  Truth truth;
  for (int number = 2; std::getline(file, line); ++number) {
    const auto row = cells_of(line);
    if (row.empty()) continue;
    const std::filesystem::path image = columns.text(row, "image");
    auto& instances = truth[image.lexically_normal().string()];
    if (columns.text(row, "x").empty()) continue;
    instances.push_back({columns.text(row, "name"),
                         {columns.number(row, "x", number), columns.number(row, "y", number),
                          to_radians(columns.number(row, "theta_deg", number))}});
  }
  return truth;
}

}  // namespace mbncc::cli
