// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "cli/arguments.hpp"
#include "mbncc/config/field.hpp"

namespace mbncc::cli {
namespace {

bool read_whole(const std::string& text, int& value) {
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end;
}

}  // namespace

cv::Rect parse_rectangle(const std::string& option, const std::string& text) {
  const auto refuse = [&] {
    throw UsageError(option + " needs x,y,w,h: four integers in pixels, w and h above 0, not '" +
                     text + "'");
  };
  std::array<int, 4> numbers{};
  std::size_t count = 0;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ','); ++count)
    if (count == numbers.size() || !read_whole(part, numbers[count])) refuse();
  if (count != numbers.size() || text.back() == ',' || numbers[2] <= 0 || numbers[3] <= 0) refuse();
  return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::vector<cv::Point2f> parse_points(const std::string& option, const std::string& text) {
  constexpr double kFarthest = 1e6;  // [px]
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
    numbers.push_back(parse_number(option, part, -kFarthest, kFarthest));
  if (numbers.empty() || numbers.size() % 2 != 0 || text.back() == ',')
    throw UsageError(option + " needs pairs of numbers x,y in pixels, not '" + text + "'");
  std::vector<cv::Point2f> points;
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    points.emplace_back(static_cast<float>(numbers[i]), static_cast<float>(numbers[i + 1]));
  return points;
}

cv::Point2f parse_point(const std::string& option, const std::string& text) {
  if (std::count(text.begin(), text.end(), ',') != 1)
    throw UsageError(option + " needs x,y: two numbers in pixels, not '" + text + "'");
  return parse_points(option, text).front();
}

int parse_whole(const std::string& option, const std::string& text, int lowest) {
  int value = 0;
  if (!read_whole(text, value) || value < lowest)
    throw UsageError(option + " needs an integer of at least " + std::to_string(lowest) +
                     ", not '" + text + "'");
  return value;
}

double parse_number(const std::string& option, const std::string& text, double low, double high) {
  double value = 0;
  parse_field({option, Allowed::range(low, high), "", ""}, text, value);
  return value;
}

double unsigned_zero(double value, int digits) {
  return std::abs(value) < 0.5 * std::pow(10, -digits) ? 0 : value;
}

}  // namespace mbncc::cli
