// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <stdexcept>

#include "library/object_yaml.hpp"
#include "library/quality_numbers.hpp"
#include "mbncc/config/field.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::library {
namespace {

constexpr double kLargest = 1e9;     // bound of all numbers except times; far beyond any image
constexpr double kLatestTime = 4e9;  // [s] since 1970; messages count seconds in 32 bits

// The parser is recursive, so the nesting depth is limited; valid descriptions are shallow.
void refuse_deep_nesting(const std::string& text) {
  const auto structural = std::count_if(text.begin(), text.end(), [](char c) {
    return c == '[' || c == '{' || c == '-' || c == '?';
  });
  if (structural > 2000) throw std::runtime_error("its description is nested too deeply");
}

// write_description() writes no aliases; when read, each alias would repeat its anchor's text.
class AliasRefusal : public YAML::EventHandler {
 public:
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {
    throw std::runtime_error("its description has aliases, which no lesson writes");
  }
  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
};

void refuse_aliases(const std::string& text) {
  if (text.find('*') == std::string::npos) return;
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  AliasRefusal refusal;
  parser.HandleNextDocument(refusal);
}

// Numbers are parsed by the field functions: exact, independent of the locale, range-checked.
double number(const YAML::Node& node, const char* key, Allowed allowed) {
  double value = 0;
  parse_field({key, std::move(allowed), "", ""}, node.as<std::string>(), value);
  return value;
}

double number(const YAML::Node& parent, const char* key, double low, double high) {
  return number(parent[key], key, Allowed::range(low, high));
}

double number_or_unknown(const YAML::Node& parent, const char* key, double low, double high) {
  return parent[key] ? number(parent, key, low, high) : Quality::kUnknown;
}

int whole(const YAML::Node& node, const char* key, double low, double high) {
  int value = 0;
  parse_field({key, Allowed::range(low, high), "", ""}, node.as<std::string>(), value);
  return value;
}

template <std::size_t N, class Read>
auto elements(const YAML::Node& parent, const char* key, Read&& read) {
  const YAML::Node list = parent[key];
  if (!list.IsSequence() || list.size() != N)
    throw std::runtime_error(std::string(key) + " must have " + std::to_string(N) + " numbers");
  std::array<decltype(read(list[0])), N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = read(list[i]);
  return values;
}

template <std::size_t N>
std::array<double, N> numbers(const YAML::Node& parent, const char* key) {
  return elements<N>(parent, key, [key](const YAML::Node& node) {
    return number(node, key, Allowed::range(-kLargest, kLargest));
  });
}

template <std::size_t N>
std::array<int, N> wholes(const YAML::Node& parent, const char* key) {
  return elements<N>(parent, key,
                     [key](const YAML::Node& node) { return whole(node, key, 0, 1e6); });
}

Verdict read_verdict(const std::string& text) {
  for (const Verdict verdict : {Verdict::kGood, Verdict::kMarginal, Verdict::kBad})
    if (text == to_string(verdict)) return verdict;
  throw std::runtime_error("its verdict '" + text + "' is not GOOD, MARGINAL or BAD");
}

Quality read_quality(const YAML::Node& node) {
  Quality quality;
  quality.verdict = read_verdict(node["verdict"].as<std::string>());
  quality.reasons = node["reasons"].as<std::vector<std::string>>();
  quality.advice = node["advice"].as<std::vector<std::string>>();
  quality.symmetry = whole(node["symmetry"], "symmetry", 0, 360);
  quality.confusable_with = node["confusable_with"].as<std::string>();
  for_each_number(quality, [&node](const char* key, double& value, double low, double high) {
    value = number_or_unknown(node, key, low, high);
  });
  return quality;
}

Grasp read_grasp(const YAML::Node& node) {
  return {numbers<3>(node, "position"), numbers<4>(node, "orientation")};
}

void read_view(const YAML::Node& node, ObjectDescription& description) {
  const auto rectangle = wholes<4>(node, "rectangle");
  const auto origin = wholes<2>(node, "origin");
  const auto size = wholes<2>(node, "picture_size");
  const auto reference = numbers<3>(node, "reference");
  View& view = description.model.views.emplace_back();
  view.origin = {origin[0], origin[1]};
  view.image_size = {size[0], size[1]};
  view.reference = {reference[0], reference[1], reference[2]};
  description.rectangles.emplace_back(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
}

void check_version(const YAML::Node& root) {
  const int version = whole(root["format"], "format", 1, 1e6);
  if (version > kObjectFileVersion)
    throw NewerFormat("it has format " + std::to_string(version) + ", this program reads " +
                      std::to_string(kObjectFileVersion) + "; update mbncc_vision");
}

ObjectDescription read_root(const YAML::Node& root) {
  ObjectDescription description;
  ObjectModel& model = description.model;
  model.label = root["label"].as<std::string>();
  model.enabled = root["enabled"].as<bool>();
  model.revision = static_cast<std::uint32_t>(whole(root["revision"], "revision", 1, kMaxRevision));
  model.learned_at = number(root, "learned_at", 0, kLatestTime);
  if (root["taught_by"]) model.taught_by = root["taught_by"].as<std::string>();
  model.object_height = number(root, "object_height", 0, kLargest);
  model.metres_per_pixel = number_or_unknown(root, "metres_per_pixel", 0, kLargest);
  if (root["min_score"]) model.min_score = number(root, "min_score", 0, 1);
  if (root["symmetry"]) model.symmetry = parse_symmetry(root["symmetry"].as<std::string>());
  if (root["grasp"]) model.grasp = read_grasp(root["grasp"]);
  model.quality = read_quality(root["quality"]);
  if (!root["views"].IsSequence() || root["views"].size() > kMaxViews)
    throw std::runtime_error("views must be a list of at most " + std::to_string(kMaxViews));
  for (const auto& view : root["views"]) read_view(view, description);
  return description;
}

}  // namespace

ObjectDescription read_description(const std::string& text) {
  refuse_deep_nesting(text);
  try {
    const YAML::Node root = YAML::Load(text);
    check_version(root);
    refuse_aliases(text);
    return read_root(root);
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(std::string("its description is damaged: ") + error.what());
  }
}

}  // namespace mbncc::library
