// SPDX-License-Identifier: BSD-3-Clause
// Writes the evidence of evidence.hpp for correct and wrong poses on evaluation sets, as rows for
// fit.py.
#include <algorithm>
#include <fstream>

#include "common/case_folder.hpp"
#include "common/csv.hpp"
#include "common/program.hpp"
#include "matching/decision/clutter.hpp"
#include "matching/evidence/evidence.hpp"
#include "matching/prepared/prepared_object.hpp"
#include "matching/scoring.hpp"
#include "matching/search/object_search.hpp"

namespace mbncc::bench {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOptions =
    "{@out   | | csv file for the rows }"
    "{@sets  | | folders of sets (bench/README.md), with commas between them }"
    "{help h | | this text }";

std::shared_ptr<ObjectModel> object_of(const CaseFolder& one) {
  auto object = std::make_shared<ObjectModel>();
  object->name = one.name;
  object->views.push_back(crop_view(one.before, one.map, {one.reference.x, one.reference.y, 0}));
  return object;
}

bool is_right(const decision::Detection& detection, const Target& target, const CaseFolder& one) {
  const Pose2D pose = compose(detection.pose, detection.view->reference_in_anchor);
  const auto judged = judge({{pose, 1, false, {}}}, target.instances, one.diameter);
  return judged.front().correct;
}

/// The best detection at each place; `detections` is sorted.
std::vector<decision::Detection> best_of_places(
    const std::vector<decision::Detection>& detections) {
  std::vector<decision::Detection> places;
  for (const auto& one : detections)
    if (std::none_of(places.begin(), places.end(), [&](const decision::Detection& other) {
          return cv::norm(one.pose.position() - other.pose.position()) <
                 decision::kSamePlace * one.view->shape.radius();
        }))
      places.push_back(one);
  return places;
}

class Rows {
 public:
  explicit Rows(const fs::path& file) : out_(file) {
    if (!out_) throw std::runtime_error("cannot write " + file.string());
    out_ << "set,case,target,right,area,odds,offset,contour_coverage,gradient,trimmed_residual,"
            "histogram,shading_free_ncc,"
            "texture,compared,cast\n";
  }

  void add_case(const fs::path& set, const CaseFolder& one) {
    const prepared::PreparedObject object(object_of(one), prepared::Engine::kFast);
    for (const auto& target : one.targets) {
      const scene::SceneImage scene(read_image(target.image), object.top_level());
      auto detections = search::search_object(object, scene, {}, search::SearchMode::kThorough);
      decision::apply_clutter_penalty(detections);
      for (const auto& detection : best_of_places(detections))
        add(set, one, target, scene, object.views[detection.view_number], detection);
    }
  }

 private:
  void add(const fs::path& set, const CaseFolder& one, const Target& target,
           const scene::SceneImage& scene, const prepared::PreparedView& view,
           const decision::Detection& detection) {
    const evidence::Evidence e =
        evidence::gather_evidence(view.fine, scene.levels[0], detection.pose, detection.scale);
    const double area = view.shape.area();
    out_ << set.string() << ',' << one.name << ',' << target.name << ','
         << is_right(detection, target, one) << ',' << area << ',' << evidence::log_odds(e, area)
         << ',' << detection.log_odds() - evidence::log_odds(e, area) << ',' << e.contour_coverage
         << ',' << e.gradient << ',' << e.trimmed_residual << ',' << e.histogram << ','
         << e.shading_free_ncc << ',' << e.texture << ',' << e.compared << ',' << e.cast << '\n';
  }

  std::ofstream out_;
};

void benchmark(const cv::CommandLineParser& options) {
  Rows rows(options.get<std::string>("@out"));
  for (const auto& set : split(options.get<std::string>("@sets"), ','))
    for (const auto& name : list_cases(set)) rows.add_case(set, read_case(fs::path(set) / name));
}

}  // namespace
}  // namespace mbncc::bench

int main(int argc, char** argv) {
  return mbncc::bench::run_program(argc, argv, "evidence_rows", mbncc::bench::kOptions, "@out",
                                   mbncc::bench::benchmark);
}
