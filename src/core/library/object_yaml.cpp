#include "library/object_yaml.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "mbncc/config/field.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc {
namespace {

constexpr double kLargest = 1e9;  // bound of every number but times; far beyond any picture
constexpr int kMaxViews = 64;

// The parser recurses; text of this kind never nests deeply, whatever a damaged file holds.
void refuse_deep_nesting(const std::string& text) {
  const auto structural = std::count_if(text.begin(), text.end(), [](char c) {
    return c == '[' || c == '{' || c == '-' || c == '?';
  });
  if (structural > 2000) throw std::runtime_error("its description is nested too deeply");
}

// Numbers pass through the field functions: exact, independent of the locale, checked for range.
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

template <std::size_t N>
std::array<double, N> numbers(const YAML::Node& parent, const char* key) {
  const YAML::Node list = parent[key];
  if (!list.IsSequence() || list.size() != N)
    throw std::runtime_error(std::string(key) + " must have " + std::to_string(N) + " numbers");
  std::array<double, N> values{};
  for (std::size_t i = 0; i < N; ++i)
    values[i] = number(list[i], key, Allowed::range(-kLargest, kLargest));
  return values;
}

template <std::size_t N>
std::array<int, N> wholes(const YAML::Node& parent, const char* key) {
  const YAML::Node list = parent[key];
  if (!list.IsSequence() || list.size() != N)
    throw std::runtime_error(std::string(key) + " must have " + std::to_string(N) + " numbers");
  std::array<int, N> values{};
  for (std::size_t i = 0; i < N; ++i) values[i] = whole(list[i], key, 0, 1e6);
  return values;
}

void put(YAML::Emitter& out, const char* key, double value) {
  if (std::isfinite(value)) out << YAML::Key << key << YAML::Value << field_text(value);
}

void put(YAML::Emitter& out, const char* key, const std::string& text) {
  out << YAML::Key << key << YAML::Value << YAML::DoubleQuoted << text;
}

void put(YAML::Emitter& out, const char* key, const std::vector<double>& values) {
  out << YAML::Key << key << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const double value : values) out << field_text(value);
  out << YAML::EndSeq;
}

void put(YAML::Emitter& out, const char* key, const std::vector<std::string>& texts) {
  out << YAML::Key << key << YAML::Value << YAML::BeginSeq;
  for (const auto& text : texts) out << YAML::DoubleQuoted << text;
  out << YAML::EndSeq;
}

void put_view(YAML::Emitter& out, const View& view, const cv::Rect& rectangle) {
  const auto as_numbers = [](auto... values) {
    return std::vector<double>{static_cast<double>(values)...};
  };
  out << YAML::BeginMap;
  put(out, "rectangle", as_numbers(rectangle.x, rectangle.y, rectangle.width, rectangle.height));
  put(out, "origin", as_numbers(view.origin.x, view.origin.y));
  put(out, "picture_size", as_numbers(view.picture_size.width, view.picture_size.height));
  put(out, "reference", as_numbers(view.reference.x, view.reference.y, view.reference.theta));
  out << YAML::EndMap;
}

void put_grasp(YAML::Emitter& out, const Grasp& grasp) {
  const auto& p = grasp.position;
  const auto& q = grasp.orientation;
  out << YAML::Key << "grasp" << YAML::Value << YAML::BeginMap;
  put(out, "position", std::vector<double>(p.begin(), p.end()));
  put(out, "orientation", std::vector<double>(q.begin(), q.end()));
  out << YAML::EndMap;
}

// The quality's numbers, once for reading and writing: visit(key, value, lowest, highest).
template <class SomeQuality, class Visitor>
void for_each_number(SomeQuality& quality, Visitor&& visit) {
  visit("area", quality.area, 0.0, kLargest);
  visit("fill", quality.fill, 0.0, 1.5);
  visit("contrast", quality.contrast, 0.0, 255.0);
  visit("edge_agreement", quality.edge_agreement, 0.0, 1.0);
  visit("change_agreement", quality.change_agreement, 0.0, 1.0);
  visit("self_score", quality.self_score, 0.0, 1.0);
  visit("self_error", quality.self_error, 0.0, kLargest);
  visit("runner_up", quality.runner_up, 0.0, 1.0);
  visit("angle_halfwidth", quality.angle_halfwidth, 0.0, 2 * kPi);
  visit("confusable_score", quality.confusable_score, 0.0, 1.0);
  visit("search_time", quality.search_time, 0.0, kLargest);
}

void put_quality(YAML::Emitter& out, const Quality& quality) {
  out << YAML::Key << "quality" << YAML::Value << YAML::BeginMap;
  put(out, "verdict", std::string(to_string(quality.verdict)));
  put(out, "reasons", quality.reasons);
  put(out, "advice", quality.advice);
  put(out, "symmetry", quality.symmetry);
  put(out, "confusable_with", quality.confusable_with);
  for_each_number(quality, [&out](const char* key, double value, double low, double high) {
    put(out, key, std::isnan(value) ? value : std::clamp(value, low, high));
  });
  out << YAML::EndMap;
}

Verdict read_verdict(const std::string& text) {
  for (const Verdict verdict : {Verdict::kGood, Verdict::kMarginal, Verdict::kBad})
    if (text == to_string(verdict)) return verdict;
  throw std::runtime_error("its verdict '" + text + "' is none of GOOD, MARGINAL, BAD");
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
  view.picture_size = {size[0], size[1]};
  view.reference = {reference[0], reference[1], reference[2]};
  description.rectangles.emplace_back(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
}

void check_version(const YAML::Node& root) {
  const int version = whole(root["format"], "format", 1, 1e6);
  if (version > kObjectFileVersion)
    throw std::runtime_error("it has format " + std::to_string(version) + ", this program reads " +
                             std::to_string(kObjectFileVersion) + "; update mbncc_vision");
}

ObjectDescription read_root(const YAML::Node& root) {
  check_version(root);
  ObjectDescription description;
  ObjectModel& model = description.model;
  model.label = root["label"].as<std::string>();
  model.enabled = root["enabled"].as<bool>();
  model.revision = static_cast<std::uint32_t>(whole(root["revision"], "revision", 1, 2e9));
  model.learned_at = number(root, "learned_at", 0, 1e12);
  model.object_height = number(root, "object_height", 0, kLargest);
  model.metres_per_pixel = number_or_unknown(root, "metres_per_pixel", 0, kLargest);
  if (root["min_score"]) model.min_score = number(root, "min_score", 0, 1);
  if (root["grasp"]) model.grasp = read_grasp(root["grasp"]);
  model.quality = read_quality(root["quality"]);
  if (!root["views"].IsSequence() || root["views"].size() > kMaxViews)
    throw std::runtime_error("views must be a list of at most " + std::to_string(kMaxViews));
  for (const auto& view : root["views"]) read_view(view, description);
  return description;
}

}  // namespace

std::string write_description(const ObjectModel& model, const std::vector<cv::Rect>& rectangles) {
  if (model.views.size() > kMaxViews)
    throw std::invalid_argument("an object has at most " + std::to_string(kMaxViews) + " views");
  YAML::Emitter out;
  out << YAML::BeginMap;
  put(out, "format", kObjectFileVersion);
  put(out, "label", model.label);
  out << YAML::Key << "enabled" << YAML::Value << model.enabled;
  put(out, "revision", model.revision);
  put(out, "learned_at", model.learned_at);
  put(out, "object_height", model.object_height);
  put(out, "metres_per_pixel", model.metres_per_pixel);
  if (model.min_score) put(out, "min_score", *model.min_score);
  if (model.grasp) put_grasp(out, *model.grasp);
  out << YAML::Key << "views" << YAML::Value << YAML::BeginSeq;
  for (std::size_t i = 0; i < model.views.size(); ++i) put_view(out, model.views[i], rectangles[i]);
  out << YAML::EndSeq;
  put_quality(out, model.quality);
  out << YAML::EndMap;
  return out.c_str();
}

ObjectDescription read_description(const std::string& text) {
  refuse_deep_nesting(text);
  try {
    return read_root(YAML::Load(text));
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(std::string("its description is damaged: ") + error.what());
  }
}

}  // namespace mbncc
