// SPDX-License-Identifier: BSD-3-Clause
#include "common/case_folder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <system_error>

#include "common/csv.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<double> numbers_of(const fs::path& path, std::size_t count) {
  std::ifstream file(path);
  std::vector<double> numbers;
  for (double number; file >> number;) numbers.push_back(number);
  if (numbers.size() < count)
    throw std::runtime_error(path.string() + " must hold " + std::to_string(count) + " numbers");
  return numbers;
}

cv::Mat read_map(const fs::path& path) {
  const cv::Mat grey = cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
  if (grey.empty()) throw std::runtime_error("cannot read the image '" + path.string() + "'");
  return grey > 127;
}

Instance instance_of(const CsvRow& row) {
  Instance instance;
  instance.pose = {std::stod(row.at("x")), std::stod(row.at("y")),
                   to_radians(std::stod(row.at("theta_deg")))};
  instance.tags = split(row.at("tags"), ';');
  instance.symmetry = symmetry_of(instance.tags);
  return instance;
}

std::vector<Target> images_in(const fs::path& folder) {
  std::vector<Target> targets;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const auto& path = entry.path();
    if (path.extension() != ".png" || path.stem().string().rfind("target_", 0) != 0) continue;
    auto& target = targets.emplace_back();
    target.name = path.stem().string();
    target.image = path;
  }
  std::sort(targets.begin(), targets.end(),
            [](const Target& a, const Target& b) { return a.name < b.name; });
  return targets;
}

std::vector<Target> read_targets(const fs::path& folder) {
  auto targets = images_in(folder);
  std::map<std::string, Target*> by_name;
  for (auto& target : targets) by_name[target.name] = &target;
  if (fs::exists(folder / "gt.csv"))
    for (const auto& row : read_csv(folder / "gt.csv"))
      by_name.at(row.at("target"))->instances.push_back(instance_of(row));
  if (fs::exists(folder / "targets.csv"))
    for (const auto& row : read_csv(folder / "targets.csv"))
      by_name.at(row.at("target"))->tags = split(row.at("tags"), ';');
  return targets;
}

/// The strings of the list "tags" in a JSON file of known form, which does not need a JSON parser.
std::vector<std::string> tags_in_json(const std::string& text) {
  std::vector<std::string> tags;
  const auto key = text.find("\"tags\"");
  if (key == std::string::npos) return tags;
  const auto open = text.find('[', key), close = text.find(']', key);
  const auto parts = split(text.substr(open + 1, close - open - 1), '"');
  std::copy_if(parts.begin(), parts.end(), std::back_inserter(tags), [](const std::string& part) {
    return part.find_first_not_of(", \n\t") != std::string::npos;
  });
  return tags;
}

}  // namespace

std::vector<std::string> list_cases(const fs::path& set, std::size_t most) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(set, unreadable))
    if (fs::exists(entry.path() / "gt_mask.png") && fs::exists(entry.path() / "learn_before.png"))
      names.push_back(entry.path().filename().string());
  if (names.empty())
    throw std::runtime_error("'" + set.string() + "' holds no case; see bench/README.md, Data");
  std::sort(names.begin(), names.end());
  if (most > 0 && most < names.size()) names.resize(most);
  return names;
}

CaseFolder read_case(const fs::path& folder) {
  CaseFolder result;
  result.name = folder.filename().string();
  result.folder = folder;
  result.before = read_image(folder / "learn_before.png");
  if (fs::exists(folder / "learn_after.png")) result.after = read_image(folder / "learn_after.png");
  if (fs::exists(folder / "roi.txt")) {
    const auto roi = numbers_of(folder / "roi.txt", 4);
    result.region = cv::Rect(cvRound(roi[0]), cvRound(roi[1]), cvRound(roi[2]), cvRound(roi[3]));
  }
  result.map = read_map(folder / "gt_mask.png");
  result.reference = centroid(result.map);
  if (fs::exists(folder / "ref.txt")) {
    const auto reference = numbers_of(folder / "ref.txt", 2);
    result.reference = {reference[0], reference[1]};
  }
  result.diameter = 2 * excircle(result.map).radius;
  result.tags = tags_in_json(text_of(folder / "meta.json"));
  result.targets = read_targets(folder);
  return result;
}

int symmetry_of(const std::vector<std::string>& tags) {
  for (const auto& tag : tags) {
    if (tag.rfind("sym:", 0) != 0) continue;
    const double period = std::stod(tag.substr(4));
    return period == 0 ? 0 : static_cast<int>(std::lround(360 / period));
  }
  return 1;
}

cv::Mat read_image(const fs::path& path) {
  cv::Mat image = cv::imread(path.string(), cv::IMREAD_COLOR);
  if (image.empty()) throw std::runtime_error("cannot read the image '" + path.string() + "'");
  return image;
}

}  // namespace mbncc::bench
