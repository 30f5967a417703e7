// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <optional>
#include <string>

#include "cli/command.hpp"
#include "cli/lesson_arguments.hpp"
#include "cli/library_access.hpp"
#include "cli/report/numbers.hpp"
#include "cli/settings.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::cli {
namespace {

/// Returns none if the search's own min_score applies.
std::optional<double> min_score_from(const Arguments& arguments) {
  const std::string text = arguments.get("--min-score", "auto");
  if (text == "auto") return {};
  const double score = parse_number("--min-score", text, 0, 1);
  if (score <= 0) throw UsageError("--min-score: give a number above 0, or auto");
  return score;
}

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  if (!arguments.has("--symmetry") && !arguments.has("--min-score"))
    throw UsageError("give --symmetry, --min-score or both");
  const auto symmetry = symmetry_from(arguments);
  const auto min_score = min_score_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  const ObjectModel object = library.edit(arguments.get("--name"), [&](ObjectModel& model) {
    if (arguments.has("--symmetry")) declare_symmetry(model, symmetry);
    if (arguments.has("--min-score")) model.min_score = min_score;
  });
  std::cout << "'" << object.name << "' has symmetry " << symmetry_text(object.symmetry);
  if (object.min_score)
    std::cout << ", is reported at a score of " << *object.min_score << " or more";
  std::cout << ", revision " << object.revision << '\n';
  return kDone;
}

}  // namespace

Command edit_command() {
  return {
      "edit",
      "declare an object's symmetry or set its own threshold",
      {library_option(),
       name_option(),
       {"--symmetry", "auto|none|2..12|round", "equal angles in a turn"},
       {"--min-score", "S", "minimum score to report it, instead of min_score; auto: min_score"}},
      "",
      "Equivalent angles do not compete, so an object can be graspable at any of them. auto: "
      "as\n measured in the image. none: the angle always matters. Another symmetry is a\n"
      "new revision, and the old one goes to the trash; --min-score alone keeps the revision.\n",
      run};
}

}  // namespace mbncc::cli
