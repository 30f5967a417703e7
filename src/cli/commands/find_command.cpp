// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/images.hpp"
#include "cli/library_access.hpp"
#include "cli/report/match_report.hpp"
#include "cli/report/overlay_writer.hpp"
#include "cli/report/search_warnings.hpp"
#include "cli/settings.hpp"
#include "cli/terminal/progress.hpp"
#include "mbncc/error.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/matching/named_objects.hpp"

namespace mbncc::cli {
namespace {

// Applies the options that set a parameter with a different name.
void apply_options(const Arguments& arguments, SearchConfig& search) {
  const auto rows = field_rows(search);
  for (const auto& [option, key] :
       {std::pair{"--min-score", "min_score"}, std::pair{"--max-instances", "max_instances"},
        std::pair{"--threads", "threads"}, std::pair{"--engine", "engine"}})
    if (arguments.has(option)) assign_field(rows, key, arguments.get(option));
}

SearchRequest request_from(const Arguments& arguments, const SearchConfig& search) {
  SearchRequest request;
  // A threshold on the command line overrides the thresholds of the objects.
  if (arguments.has("--min-score")) request.min_score = search.min_score;
  return request;
}

std::unique_ptr<MatchReport> report_for(const Arguments& arguments) {
  if (arguments.has("--csv")) return csv_report(std::cout);
  if (arguments.has("--json")) return json_report(std::cout);
  return plain_report(std::cout);
}

SearchResult searched(const Matcher& matcher, const std::string& image_path, const cv::Mat& image,
                      const SearchRequest& request) {
  try {
    return matcher.find(image, request);
  } catch (const std::invalid_argument& error) {
    throw FileError(image_path, error.what());
  }
}

ExitCode run(const Arguments& arguments) {
  arguments.at_most_one_of({"--csv", "--json"});
  Settings settings = settings_from(arguments);
  apply_options(arguments, settings.search());
  ObjectLibrary library = existing_library(arguments);
  const auto snapshot = load_objects(library);
  const auto names = arguments.all("--name");
  for (const auto& name : names) named_object(*snapshot, name);
  Matcher matcher(settings.search());
  matcher.set_objects(snapshot->objects);
  const SearchRequest request = request_from(arguments, settings.search());
  OverlayWriter overlay(arguments.get("--overlay"), arguments.operands());
  const auto report = report_for(arguments);
  ExitCode code = kDone;
  {
    // On a terminal, the printed lines already show the progress.
    Progress progress("searched", arguments.operands().size(), Progress::kQuietOutput);
    for (const auto& image_path : arguments.operands()) {
      try {
        const cv::Mat image = read_image(image_path);
        SearchResult result = searched(matcher, image_path, image, request);
        keep_named(names, *snapshot, result);
        warn_of_skipped(image_path, result);
        warn_of_other_size(image_path, image.size(), *snapshot, names);
        report->add(image_path, image.size(), result);
        overlay.write(image_path, image, result.matches);
      } catch (const std::exception& error) {
        std::cerr << "mbncc: " << error.what() << '\n';
        code = kFailed;
      }
      progress.step();
    }
  }
  overlay.tell();
  return code;
}

}  // namespace

Command find_command() {
  return {"find",
          "find learned objects in images",
          {library_option(),
           {"--name", "NAME", "report this object only", false, true},
           {"--min-score", "S", "minimum score of reported detections"},
           {"--max-instances", "N", "detections per object and image"},
           {"--threads", "T", "worker threads"},
           {"--engine", "fast|polar",
            "polar: the paper's matching in the polar domain, never graspable"},
           {"--csv", "", "print CSV"},
           json_option(),
           {"--overlay", "DIR", "write each image with its detections"}},
          "IMAGE",
          "x and y are the position of the object's reference point in pixels; theta is its "
          "rotation,\n clockwise on screen. An image that cannot be read is reported on stderr, "
          "the others\n are searched, and the exit code is 1.\n",
          run};
}

}  // namespace mbncc::cli
