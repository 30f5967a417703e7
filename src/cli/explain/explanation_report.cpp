// SPDX-License-Identifier: BSD-3-Clause
#include "cli/explain/explanation_report.hpp"

#include "cli/report/json_writer.hpp"
#include "mbncc/miss/saved_miss.hpp"

namespace mbncc::cli {
namespace {

const char* word_of(Explanation::Outcome outcome) {
  switch (outcome) {
    case Explanation::Outcome::kGraspable:
      return "graspable";
    case Explanation::Outcome::kReported:
      return "reported";
    case Explanation::Outcome::kRejected:
      return "rejected";
    default:
      return "not_proposed";
  }
}

void write(JsonWriter& json, const Explanation& one) {
  json.member("name", one.name).member("outcome", word_of(one.outcome));
  json.member("x", one.pose.x).member("y", one.pose.y);
  json.member("theta_deg", to_degrees(one.pose.theta));
  json.member("score", one.score).member("log_odds", one.odds.total());
  json.member("evidence", one.odds.evidence).member("colour", -one.odds.colour);
  json.member("mirror", -one.odds.mirror).member("print", -one.odds.print);
  json.member("rotations", one.odds.rotations());
  json.member("clutter", -one.odds.clutter).member("calibration", one.odds.calibration);
  json.key("parts").begin_array();
  for (const auto& part : one.parts) {
    json.begin_object().member("name", part.name).member("value", part.value);
    json.member("lacking", part.lacking).end_object();
  }
  json.end_array().key("checks").begin_array();
  for (const auto& check : one.checks) {
    json.begin_object().member("name", check.name).member("value", check.value);
    json.member("threshold", check.threshold).member("passed", check.passed).end_object();
  }
  json.end_array().key("rivals").begin_array();
  for (const auto& rival : one.competitors) {
    json.begin_object().member("name", rival.name).member("x", rival.position.x);
    json.member("y", rival.position.y).member("log_odds", rival.log_odds).end_object();
  }
  json.end_array().member("covered_by", one.covered_by).member("reasons", one.reasons);
  json.member("sentences", lines_of(one));
}

}  // namespace

void print_explanations(std::ostream& out, const std::vector<Explanation>& explanations) {
  for (const auto& line : lines_of(explanations, kExplained)) out << "  " << line << '\n';
}

void write_explanations(std::ostream& out, const std::string& image, cv::Point2d place,
                        const std::vector<Explanation>& explanations) {
  for (const auto& one : explanations) {
    JsonWriter json(out);
    json.begin_object().member("image", image);
    json.member("at_x", place.x).member("at_y", place.y);
    write(json, one);
    json.end_object();
  }
}

}  // namespace mbncc::cli
