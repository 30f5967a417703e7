// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/lesson_report.hpp"

#include <iomanip>

#include "cli/report/json_writer.hpp"
#include "cli/report/numbers.hpp"
#include "cli/report/object_report.hpp"

namespace mbncc::cli {
namespace {

// Writes the view that this lesson added, which is the newest one of the object.
void write_view(JsonWriter& json, const View& view) {
  json.key("reference").begin_object();
  json.member("x", view.reference.x).member("y", view.reference.y);
  json.member("theta_deg", to_degrees(view.reference.theta)).end_object();
  json.member("radius", excircle(view.map).radius);
  json.member("area", cv::countNonZero(view.map));
}

void write_put_aside(JsonWriter& json, const PutAside& put_aside) {
  json.key("put_aside").begin_object();
  json.member("x", put_aside.pose.x).member("y", put_aside.pose.y);
  json.member("theta_deg", to_degrees(put_aside.pose.theta));
  json.member("agreement", put_aside.agreement).member("refined", put_aside.refined).end_object();
}

}  // namespace

void write_lesson(std::ostream& out, const LearnResult& result, const std::string& file) {
  const ObjectModel& object = result.object;
  JsonWriter json(out);
  json.begin_object().member("name", object.name);
  if (result.has_model) {
    json.member("verdict", to_string(object.quality.verdict));
    json.member("reasons", object.quality.reasons).member("advice", object.quality.advice);
    write_view(json, object.views.back());
    if (result.put_aside) write_put_aside(json, *result.put_aside);
    json.member("revision", object.revision);
    write_quality(json.key("quality"), object.quality);
  }
  json.member("stored", result.error == LearnError::kSuccess).member("file", file);
  json.member("error_code", static_cast<int>(result.error))
      .member("error", to_string(result.error));
  json.member("message", result.message).member("hint", result.hint);
  json.key("timings_ms").begin_object();
  for (const auto& [step, milliseconds] : result.timings_ms) json.member(step, milliseconds);
  json.end_object().end_object();
}

void print_lesson(std::ostream& out, const LearnResult& result, const std::string& file) {
  const ObjectModel& object = result.object;
  const View& view = object.views.back();
  out << "learned '" << object.name << "', revision " << object.revision << ": "
      << to_string(object.quality.verdict) << std::fixed << std::setprecision(1)
      << "\n  reference (" << view.reference.x << ", " << view.reference.y << "), excircle radius "
      << excircle(view.map).radius << " px, area " << cv::countNonZero(view.map) << " px, "
      << result.timings_ms.at("total") << " ms\n  stored in " << file << '\n';
  if (result.put_aside)
    out << "  put aside to (" << result.put_aside->pose.x << ", " << result.put_aside->pose.y
        << "), " << unsigned_zero(to_degrees(result.put_aside->pose.theta), 1) << " deg\n";
  for (const auto& advice : object.quality.advice) out << "  " << advice << '\n';
}

}  // namespace mbncc::cli
