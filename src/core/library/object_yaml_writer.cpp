// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "library/object_yaml.hpp"
#include "library/quality_numbers.hpp"
#include "mbncc/config/field.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::library {
namespace {

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
  put(out, "picture_size", as_numbers(view.image_size.width, view.image_size.height));
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
  if (!model.taught_by.empty()) put(out, "taught_by", model.taught_by);
  put(out, "object_height", model.object_height);
  put(out, "metres_per_pixel", model.metres_per_pixel);
  if (model.min_score) put(out, "min_score", *model.min_score);
  if (model.symmetry) put(out, "symmetry", symmetry_text(model.symmetry));
  if (model.grasp) put_grasp(out, *model.grasp);
  out << YAML::Key << "views" << YAML::Value << YAML::BeginSeq;
  for (std::size_t i = 0; i < model.views.size(); ++i) put_view(out, model.views[i], rectangles[i]);
  out << YAML::EndSeq;
  put_quality(out, model.quality);
  out << YAML::EndMap;
  return out.c_str();
}

}  // namespace mbncc::library
