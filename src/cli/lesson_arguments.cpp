// SPDX-License-Identifier: BSD-3-Clause
#include "cli/lesson_arguments.hpp"

#include "cli/command.hpp"
#include "cli/images.hpp"
#include "cli/report/numbers.hpp"
#include "mbncc/config/field.hpp"
#include "mbncc/config/learning_config.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::cli {
namespace {

/// "auto|change_cut|...": the values that LearningConfig allows.
std::string segmentation_methods() {
  LearningConfig config;
  std::string methods;
  for (const auto& row : field_rows(config))
    if (row.info.name == "method")
      for (const auto& choice : row.info.allowed.choices)
        methods += (methods.empty() ? "" : "|") + choice;
  return methods;
}

}  // namespace

std::vector<Option> lesson_options() {
  return {library_option(),
          name_option(),
          {"--before", "B.png", "image with the object, PNG or JPEG", true},
          {"--after", "A.png", "the same scene without the object"},
          {"--roi", "x,y,w,h", "approximate region of the object in pixels"},
          {"--click", "x,y", "a point on the object in pixels"},
          {"--map", "M.png", "complete map of the image's size, white on the object"},
          {"--method", segmentation_methods(),
           "of segmentation; change_cut needs --after; default: auto"},
          {"--include", "x,y[,x,y...]", "a stroke on the object", false, true},
          {"--exclude", "x,y[,x,y...]", "a stroke on the background", false, true},
          {"--stroke-width", "PIXELS", "of the strokes; 0: closed areas; default: 5"},
          {"--label", "TEXT", "shown to the operator; default: the name"},
          {"--height", "METRES", "of the object's top face above the platform; default: 0"},
          {"--symmetry", "auto|none|2..12|round", "equal angles in a turn; default: auto"},
          {"--overwrite", "", "replace the object of this name, if there is one"},
          {"--add-view", "", "add an image to the object of this name"},
          {"--allow-bad", "", "store it even if the verdict is BAD"},
          {"--stages", "DIR", "write images of the steps"},
          json_option()};
}

void check_lesson_arguments(const Arguments& arguments) {
  arguments.at_most_one_of({"--roi", "--map", "--click"});
  arguments.at_most_one_of({"--map", "--method"});
  arguments.at_most_one_of({"--overwrite", "--add-view"});
  if (!arguments.has("--after") && !arguments.has("--roi") && !arguments.has("--map") &&
      !arguments.has("--click"))
    throw UsageError(
        "--before alone does not give the object's place; add --after, --roi, --click or --map");
  if (arguments.has("--stroke-width") && !arguments.has("--include") && !arguments.has("--exclude"))
    throw UsageError("--stroke-width needs --include or --exclude");
  symmetry_from(arguments);
  if (arguments.get("--method") == "change_cut" && !arguments.has("--after"))
    throw UsageError("--method change_cut needs --after, an image without the object");
}

Lesson lesson_from(const Arguments& arguments) {
  Lesson lesson;
  lesson.name = arguments.get("--name");
  lesson.label = arguments.get("--label");
  lesson.object_height = parse_number("--height", arguments.get("--height", "0"), 0, 10);
  lesson.symmetry = symmetry_from(arguments);
  if (arguments.has("--roi")) lesson.region = parse_rectangle("--roi", arguments.get("--roi"));
  if (arguments.has("--click")) lesson.click = parse_point("--click", arguments.get("--click"));
  lesson.before = read_image(arguments.get("--before"));
  if (arguments.has("--after")) lesson.after = read_image(arguments.get("--after"));
  if (arguments.has("--map")) lesson.map = read_map(arguments.get("--map"));
  return lesson;
}

std::optional<int> symmetry_from(const Arguments& arguments) {
  try {
    return parse_symmetry(arguments.get("--symmetry", "auto"));
  } catch (const std::invalid_argument& fault) {
    throw UsageError(std::string("--symmetry: ") + fault.what());
  }
}

std::optional<LessonEdit> edit_from(const Arguments& arguments) {
  LessonEdit edit;
  for (const auto& text : arguments.all("--include"))
    edit.include.push_back(parse_points("--include", text));
  for (const auto& text : arguments.all("--exclude"))
    edit.exclude.push_back(parse_points("--exclude", text));
  edit.stroke_width = parse_number("--stroke-width", arguments.get("--stroke-width", "5"), 0, 1000);
  if (edit.include.empty() && edit.exclude.empty()) return std::nullopt;
  return edit;
}

}  // namespace mbncc::cli
