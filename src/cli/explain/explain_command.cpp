// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>

#include "cli/command.hpp"
#include "cli/explain/explanation_report.hpp"
#include "cli/images.hpp"
#include "cli/library_access.hpp"
#include "cli/report/numbers.hpp"
#include "cli/settings.hpp"
#include "mbncc/error.hpp"
#include "mbncc/miss/saved_miss.hpp"

namespace mbncc::cli {
namespace {

SavedMiss asked(const Arguments& arguments) {
  SavedMiss miss;
  miss.search = settings_from(arguments).search();
  miss.place = parse_point("--at", arguments.get("--at"));
  ObjectLibrary library = existing_library(arguments);
  const auto snapshot = load_objects(library);
  miss.objects = snapshot->objects;
  miss.names = arguments.all("--name");
  for (const auto& name : miss.names) named_object(*snapshot, name);
  miss.image = read_image(arguments.operands().front());
  return miss;
}

ExitCode run(const Arguments& arguments) {
  if (arguments.operands().size() != 1)
    throw UsageError("explain takes one image, not " + std::to_string(arguments.operands().size()));
  SavedMiss miss = asked(arguments);
  const auto explanations = explain(miss);
  if (arguments.has("--json"))
    write_explanations(std::cout, arguments.operands().front(), miss.place, explanations);
  else
    print_explanations(std::cout, explanations);
  if (arguments.has("--overlay")) {
    write_image(arguments.get("--overlay"), draw_explanation(miss.image, miss.place, explanations),
                arguments.operands());
    std::cerr << "mbncc: wrote " << arguments.get("--overlay") << '\n';
  }
  if (arguments.has("--save")) {
    refuse_to_replace(arguments.get("--save"), arguments.operands());
    miss.lines = lines_of(explanations, kExplained);
    write_miss(arguments.get("--save"), miss);
    std::cerr << "mbncc: wrote " << arguments.get("--save") << "; 'mbncc replay' repeats it\n";
  }
  return kDone;
}

}  // namespace

Command explain_command() {
  return {"explain",
          "explain why objects are found at a place in an image or not",
          {library_option(),
           {"--at", "x,y", "the place in pixels, on the object", true},
           {"--name", "NAME", "explain this object only", false, true},
           {"--overlay", "FILE.png", "write the image with place, best pose and competitors"},
           {"--save", "FILE.miss", "store image, library, settings and reason in one file"},
           json_option()},
          "IMAGE",
          "Every enabled object is searched as by 'mbncc find'; then its best pose near the place "
          "is\n printed with each term of its score, the thresholds and the competitors. 'lacks' "
          "is the\n difference of a term to its largest log-odds.\n",
          run};
}

}  // namespace mbncc::cli
