// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/object_report.hpp"

#include <cmath>
#include <ctime>
#include <iomanip>

#include "mbncc/config/field.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::cli {
namespace {

std::string number_or_unknown(double value, const char* unit) {
  return std::isfinite(value) ? field_text(value) + " " + unit : "unknown";
}

void write_pose(JsonWriter& json, const Pose2D& pose) {
  json.begin_object().member("x", pose.x).member("y", pose.y);
  json.member("theta_deg", to_degrees(pose.theta)).end_object();
}

void write_view(JsonWriter& json, const View& view) {
  json.begin_object();
  json.member("picture_width", view.image_size.width);
  json.member("picture_height", view.image_size.height);
  write_pose(json.key("reference"), view.reference);
  json.member("radius", excircle(view.map).radius);
  json.member("area", cv::countNonZero(view.map));
  json.end_object();
}

void write_grasp(JsonWriter& json, const Grasp& grasp) {
  json.begin_object().key("position").begin_array();
  for (const double value : grasp.position) json.value(value);
  json.end_array().key("orientation").begin_array();
  for (const double value : grasp.orientation) json.value(value);
  json.end_array().end_object();
}

void print_view(std::ostream& out, std::size_t number, const View& view) {
  out << "  view " << number << ": image " << view.image_size.width << " x "
      << view.image_size.height << " px, reference (" << std::fixed << std::setprecision(2)
      << view.reference.x << ", " << view.reference.y << ") at " << to_degrees(view.reference.theta)
      << " deg, excircle radius " << excircle(view.map).radius << " px, area "
      << cv::countNonZero(view.map) << " px\n"
      << std::defaultfloat;
}

}  // namespace

std::string time_text(double seconds_since_1970) {
  const auto seconds = static_cast<std::time_t>(seconds_since_1970);
  std::tm broken_down{};
  char text[32];
  if (seconds == 0 || ::gmtime_r(&seconds, &broken_down) == nullptr ||
      std::strftime(text, sizeof text, "%F %T UTC", &broken_down) == 0)
    return "unknown";
  return text;
}

void write_quality(JsonWriter& json, const Quality& quality) {
  json.begin_object();
  json.member("verdict", to_string(quality.verdict));
  json.member("reasons", quality.reasons).member("advice", quality.advice);
  json.member("area", quality.area).member("fill", quality.fill);
  json.member("contrast", quality.contrast).member("edge_agreement", quality.edge_agreement);
  json.member("change_agreement", quality.change_agreement);
  json.member("outline_probability", quality.outline_probability);
  json.member("self_score", quality.self_score).member("self_error", quality.self_error);
  json.member("runner_up", quality.runner_up).member("angle_halfwidth", quality.angle_halfwidth);
  json.member("symmetry", quality.symmetry);
  json.member("confusable_with", quality.confusable_with);
  json.member("confusable_score", quality.confusable_score);
  json.member("search_time", quality.search_time).end_object();
}

void write_object(JsonWriter& json, const ObjectModel& object) {
  json.begin_object();
  json.member("name", object.name).member("label", object.label);
  json.member("enabled", object.enabled).member("revision", object.revision);
  json.member("learned_at", object.learned_at).member("taught_by", object.taught_by);
  json.member("metres_per_pixel", object.metres_per_pixel);
  json.member("object_height", object.object_height);
  json.member("symmetry", symmetry_text(object.symmetry));
  if (object.min_score) json.member("min_score", *object.min_score);
  if (object.grasp) write_grasp(json.key("grasp"), *object.grasp);
  json.key("views").begin_array();
  for (const auto& view : object.views) write_view(json, view);
  json.end_array();
  write_quality(json.key("quality"), object.quality);
  json.end_object();
}

void print_object(std::ostream& out, const ObjectModel& object) {
  const Quality& quality = object.quality;
  out << object.name << " (" << object.label << ")\n"
      << "  revision " << object.revision << ", learned " << time_text(object.learned_at)
      << (object.taught_by.empty() ? "" : " by " + object.taught_by) << ", "
      << (object.enabled ? "enabled" : "disabled: not searched") << '\n';
  for (std::size_t i = 0; i < object.views.size(); ++i) print_view(out, i + 1, object.views[i]);
  out << "  scale " << number_or_unknown(object.metres_per_pixel, "m/px") << ", height "
      << field_text(object.object_height) << " m, grasp " << (object.grasp ? "set" : "not set")
      << ", own threshold " << (object.min_score ? field_text(*object.min_score) : "none") << '\n'
      << "  symmetry " << symmetry_text(object.symmetry.value_or(quality.symmetry))
      << (object.symmetry ? ", declared" : ", as measured") << '\n'
      << "  verdict " << to_string(quality.verdict) << '\n';
  for (const auto& advice : quality.advice) out << "    " << advice << '\n';
}

}  // namespace mbncc::cli
