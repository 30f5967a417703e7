#include <iostream>

#include "cli/command.hpp"
#include "cli/lesson_arguments.hpp"
#include "cli/library_access.hpp"
#include "cli/settings.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc::cli {
namespace {

ExitCode run(const Arguments& arguments) {
  settings_from(arguments);
  const auto symmetry = symmetry_from(arguments);
  ObjectLibrary library = existing_library(arguments);
  const ObjectModel object = library.edit(
      arguments.get("--name"), [&](ObjectModel& model) { declare_symmetry(model, symmetry); });
  std::cout << "'" << object.name << "' has symmetry " << symmetry_text(object.symmetry)
            << ", revision " << object.revision << '\n';
  return kDone;
}

}  // namespace

Command edit_command() {
  return {
      "edit",
      "declare an object's symmetry",
      {library_option(),
       name_option(),
       {"--symmetry", "S", "equal angles in a turn: auto, none, 2, 3, 4, 6 or round", true}},
      "",
      "Equal angles do not compete, so an object can be graspable at any of them. auto: what\n"
      "the picture shows for certain. none: the angle always matters. What it replaces goes to\n"
      "the trash.\n",
      run};
}

}  // namespace mbncc::cli
