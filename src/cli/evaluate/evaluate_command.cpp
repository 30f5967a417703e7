// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>

#include "cli/command.hpp"
#include "cli/evaluate/evaluation.hpp"
#include "cli/evaluate/evaluation_page.hpp"
#include "cli/images.hpp"
#include "cli/library_access.hpp"
#include "cli/report/json_writer.hpp"
#include "cli/report/numbers.hpp"
#include "cli/report/search_warnings.hpp"
#include "cli/settings.hpp"
#include "cli/terminal/progress.hpp"
#include "mbncc/error.hpp"

namespace mbncc::cli {
namespace {

bool is_image(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), ::tolower);
  return ending == ".png" || ending == ".jpg" || ending == ".jpeg";
}

/// The operands, with each folder replaced by its images, or by those that `truth` lists.
std::vector<std::string> images_of(const std::vector<std::string>& operands, const Truth& truth) {
  std::vector<std::string> images;
  for (const auto& operand : operands) {
    if (!std::filesystem::is_directory(operand)) {
      images.push_back(operand);
      continue;
    }
    std::vector<std::string> inside;
    for (const auto& entry : std::filesystem::directory_iterator(operand))
      if (is_image(entry.path()) && entry_of(truth, entry.path().string()) != truth.end())
        inside.push_back(entry.path().string());
    if (inside.empty()) throw FileError(operand, "none of its images is listed by --truth");
    std::sort(inside.begin(), inside.end());
    images.insert(images.end(), inside.begin(), inside.end());
  }
  return images;
}

/// Images that `truth` lists but that were not given, sorted.
std::vector<std::string> not_given(const Truth& truth, const std::vector<std::string>& images) {
  std::set<std::string> given;
  for (const auto& image : images) {
    const auto entry = entry_of(truth, image);
    if (entry != truth.end()) given.insert(entry->first);
  }
  std::vector<std::string> missing;
  for (const auto& [image_path, instances] : truth)
    if (given.count(image_path) == 0) missing.push_back(image_path);
  return missing;
}

void tell_not_given(const std::vector<std::string>& missing) {
  constexpr std::size_t kNamed = 5;
  if (missing.empty()) return;
  std::cerr << "mbncc: warning: " << missing.size() << " listed images were not given:";
  for (std::size_t i = 0; i < std::min(kNamed, missing.size()); ++i) std::cerr << ' ' << missing[i];
  std::cerr << (missing.size() > kNamed ? " ...\n" : "\n");
}

void write_json(const std::string& image_path, const Comparison& comparison) {
  JsonWriter json(std::cout);
  json.begin_object().member("image", image_path);
  json.member("right", static_cast<int>(comparison.right.size()));
  json.key("missed").begin_array();
  for (const auto& one : comparison.missed)
    json.begin_object()
        .member("name", one.name)
        .member("x", one.pose.x)
        .member("y", one.pose.y)
        .end_object();
  json.end_array().key("wrong").begin_array();
  for (const auto& one : comparison.wrong)
    json.begin_object()
        .member("name", one.name)
        .member("x", one.pose.x)
        .member("y", one.pose.y)
        .member("score", one.score)
        .member("graspable", one.graspable)
        .end_object();
  json.end_array().end_object();
}

void write_json(const Figures& figures, std::size_t not_given) {
  JsonWriter json(std::cout);
  json.begin_object().member("pictures", figures.images).member("instances", figures.instances);
  json.member("not_given", static_cast<int>(not_given));
  json.member("recall", figures.recall()).member("precision", figures.precision());
  json.member("recall_graspable", figures.recall_graspable());
  json.member("precision_graspable", figures.precision_graspable());
  json.member("wrong_graspable", figures.wrong_graspable);
  json.member("place_median_px", quantile(figures.place_errors, 0.5));
  json.member("place_95_px", quantile(figures.place_errors, 0.95));
  json.member("angle_median_deg", to_degrees(quantile(figures.angle_errors, 0.5)));
  json.member("angle_95_deg", to_degrees(quantile(figures.angle_errors, 0.95)));
  json.member("seconds", figures.seconds).end_object();
}

void print_faults(const std::string& image_path, const Comparison& comparison) {
  for (const auto& one : comparison.missed)
    std::cout << "  " << image_path << ": missed " << one.name << " at (" << one.pose.x << ", "
              << one.pose.y << ")\n";
  for (const auto& one : comparison.wrong)
    std::cout << "  " << image_path << ": wrong " << one.name << " at (" << one.pose.x << ", "
              << one.pose.y << "), score " << one.score
              << (one.graspable ? ", GRASPABLE\n" : ", not graspable\n");
}

Tolerance tolerance_of(const Arguments& arguments) {
  Tolerance tolerance;
  tolerance.place =
      parse_number("--place-tolerance", arguments.get("--place-tolerance", "5"), 0, 1000);
  tolerance.angle = to_radians(
      parse_number("--angle-tolerance", arguments.get("--angle-tolerance", "5"), 0, 180));
  return tolerance;
}

void check_names(const Truth& truth, const LibrarySnapshot& library, const std::string& path) {
  for (const auto& [image_path, instances] : truth)
    for (const auto& one : instances) {
      if (one.name.empty() && library.objects.size() > 1)
        throw FileError(path, "it has no column 'name', but the library has several objects");
      if (!one.name.empty()) named_object(library, one.name);
    }
}

ExitCode run(const Arguments& arguments) {
  const Tolerance tolerance = tolerance_of(arguments);
  const Truth truth = read_truth(arguments.get("--truth"));
  ObjectLibrary library = existing_library(arguments);
  const auto snapshot = load_objects(library);
  check_names(truth, *snapshot, arguments.get("--truth"));
  Matcher matcher(settings_from(arguments).search());
  matcher.set_objects(snapshot->objects);
  const auto images = images_of(arguments.operands(), truth);
  EvaluationPage page(arguments.get("--page"), images);
  Figures figures;
  const auto missing = not_given(truth, images);
  tell_not_given(missing);
  {
    Progress progress("evaluated", images.size());
    for (const auto& image_path : images) {
      try {
        const cv::Mat image = read_image(image_path);
        const SearchResult found = matcher.find(image);
        warn_of_skipped(image_path, found);
        warn_of_other_size(image_path, image.size(), *snapshot, {});
        const auto listed = entry_of(truth, image_path);
        const Comparison comparison =
            compare(listed == truth.end() ? std::vector<TrueInstance>{} : listed->second,
                    found.matches, tolerance);
        figures.add(comparison, found.search_time);
        page.add(image_path, image, comparison);
        if (arguments.has("--json"))
          write_json(image_path, comparison);
        else
          print_faults(image_path, comparison);
      } catch (const std::exception& error) {
        std::cerr << "mbncc: " << error.what() << '\n';
        ++figures.unreadable;
      }
      progress.step();
    }
  }
  if (arguments.has("--json"))
    write_json(figures, missing.size());
  else
    for (const auto& sentence : sentences_of(figures)) std::cout << sentence << '\n';
  const std::string written = page.finish(figures);
  if (!written.empty()) std::cerr << "mbncc: wrote " << written << '\n';
  return figures.unreadable > 0 ? kFailed : kDone;
}

}  // namespace

Command evaluate_command() {
  return {
      "evaluate",
      "search images of known content: recall, precision, errors, misses",
      {library_option(),
       {"--truth", "TRUTH.csv", "true poses: image,name,x,y,theta_deg", true},
       {"--place-tolerance", "PIXELS", "largest position error of a right detection; default: 5"},
       {"--angle-tolerance", "DEGREES", "largest angle error, modulo symmetry; default: 5"},
       {"--page", "DIR", "write a page with the images of misses and wrong detections"},
       json_option()},
      "IMAGE|DIR",
      "A given image that is not listed contains no object: detections in it are wrong. Of a\n "
      "folder, only the listed images are used. Without the column name the library must hold\n "
      "one object. --json prints an object per image and line, the figures last.\n",
      run};
}

}  // namespace mbncc::cli
