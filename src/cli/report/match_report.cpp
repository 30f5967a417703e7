// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/match_report.hpp"

#include <iomanip>
#include <map>

#include "cli/report/json_writer.hpp"
#include "cli/report/numbers.hpp"

namespace mbncc::cli {
namespace {

// Counts the instances of each name, starting at 0.
class InstanceCounter {
 public:
  int next(const std::string& name) { return counts_[name]++; }

 private:
  std::map<std::string, int> counts_;
};

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string joined(const std::vector<std::string>& reasons) {
  std::string text;
  for (const auto& reason : reasons) text += (text.empty() ? "" : "; ") + reason;
  return text;
}

class CsvReport : public MatchReport {
 public:
  explicit CsvReport(std::ostream& out) : out_(out) {
    out_ << "image,name,instance,x,y,theta_deg,score,similarity,margin_place,margin_angle,"
            "graspable,ms\n"
         << std::fixed << std::setprecision(4);
  }

  void add(const std::string& image, const cv::Size&, const SearchResult& result) override {
    InstanceCounter instances;
    const double ms = 1000 * result.search_time;
    for (const auto& match : result.matches) {
      out_ << csv_text(image) << ',' << match.name << ',' << instances.next(match.name);
      for (const double value :
           {match.pose.x, match.pose.y, to_degrees(match.pose.theta), match.score, match.similarity,
            match.margin_place, match.margin_angle})
        out_ << ',' << value;
      out_ << ',' << (match.graspable ? "true" : "false") << ',' << ms << '\n';
    }
    if (result.matches.empty()) out_ << csv_text(image) << ",,,,,,,,,,," << ms << '\n';
  }

 private:
  std::ostream& out_;
};

class JsonReport : public MatchReport {
 public:
  explicit JsonReport(std::ostream& out) : out_(out) {}

  void add(const std::string& image, const cv::Size& size, const SearchResult& result) override {
    JsonWriter json(out_);
    json.begin_object().member("image", image);
    json.member("width", size.width).member("height", size.height);
    json.member("ms", 1000 * result.search_time);
    json.member("searched", result.searched).member("skipped", result.skipped);
    json.member("budget_exceeded", result.budget_exceeded).member("limited", result.limited);
    InstanceCounter instances;
    json.key("objects").begin_array();
    for (const auto& match : result.matches) write(json, match, instances.next(match.name));
    json.end_array().end_object();
  }

 private:
  static void write(JsonWriter& json, const Match& match, int instance) {
    json.begin_object().member("name", match.name).member("revision", match.revision);
    json.member("instance", instance);
    json.member("x", match.pose.x).member("y", match.pose.y);
    json.member("theta_deg", to_degrees(match.pose.theta)).member("theta", match.pose.theta);
    json.member("scale", match.scale).member("score", match.score);
    json.member("similarity", match.similarity);
    json.member("margin_place", match.margin_place).member("margin_angle", match.margin_angle);
    json.member("visible", match.visible).member("symmetry", match.symmetry);
    json.member("graspable", match.graspable).member("ambiguous", match.ambiguous);
    json.member("reasons", match.reasons);
    json.key("covariance").begin_array();
    for (const double value : match.covariance.val) json.value(value);
    json.end_array().key("outline").begin_array();
    for (const auto& point : match.outline)
      json.begin_array().value(double{point.x}).value(double{point.y}).end_array();
    json.end_array().end_object();
  }

  std::ostream& out_;
};

class PlainReport : public MatchReport {
 public:
  explicit PlainReport(std::ostream& out) : out_(out) {}

  void add(const std::string& image, const cv::Size&, const SearchResult& result) override {
    out_ << image << ": " << std::fixed << std::setprecision(1) << 1000 * result.search_time
         << " ms" << (result.matches.empty() ? ", nothing found\n" : "\n");
    for (const auto& name : result.limited)
      out_ << "  max_instances reached by " << name
           << "; there may be more, raise --max-instances\n";
    for (const auto& match : result.matches) {
      out_ << "  " << match.name << " at (" << std::setprecision(2) << match.pose.x << ", "
           << match.pose.y << "), " << unsigned_zero(to_degrees(match.pose.theta), 2)
           << " deg, score " << match.score
           << (match.graspable   ? ""
               : match.ambiguous ? ", ambiguous, do not grasp: "
                                 : ", too uncertain to grasp: ")
           << joined(match.reasons) << '\n';
    }
  }

 private:
  std::ostream& out_;
};

}  // namespace

std::unique_ptr<MatchReport> csv_report(std::ostream& out) {
  return std::make_unique<CsvReport>(out);
}
std::unique_ptr<MatchReport> json_report(std::ostream& out) {
  return std::make_unique<JsonReport>(out);
}
std::unique_ptr<MatchReport> plain_report(std::ostream& out) {
  return std::make_unique<PlainReport>(out);
}

}  // namespace mbncc::cli
