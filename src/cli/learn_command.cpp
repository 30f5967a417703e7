#include <iostream>
#include <sstream>

#include "cli/command.hpp"
#include "cli/lesson_arguments.hpp"
#include "cli/lesson_report.hpp"
#include "cli/library_access.hpp"
#include "cli/settings.hpp"
#include "cli/stage_writer.hpp"
#include "mbncc/error.hpp"
#include "mbncc/learning/add_view.hpp"
#include "mbncc/learning/learn_object.hpp"

namespace mbncc::cli {
namespace {

void refuse(LearnResult& result, LearnError error, const std::string& message = "") {
  result.error = error;
  result.message = message.empty() ? message_of(error) : message;
  result.hint = hint_of(error);
}

// Before the lesson, so that nobody waits for what cannot be stored.
LearnError check_name(const Arguments& arguments, ObjectLibrary& library) {
  const std::string name = arguments.get("--name");
  if (!is_valid_name(name)) return LearnError::kNameInvalid;
  const bool known = load_reporting(library)->find(name) != nullptr;
  if (known && !arguments.has("--overwrite") && !arguments.has("--add-view"))
    return LearnError::kNameTaken;
  if (!known && arguments.has("--add-view")) return LearnError::kNameUnknown;
  return LearnError::kSuccess;
}

bool may_store(const LearnResult& result, const Arguments& arguments) {
  return result.has_model && (result.error == LearnError::kSuccess || arguments.has("--allow-bad"));
}

ObjectModel add_view(ObjectLibrary& library, const LearnResult& result, const cv::Mat& picture,
                     const SearchConfig& search) {
  return library.edit(result.object.name, [&](ObjectModel& stored) {
    View view = result.object.views.front();
    const auto reference = shared_reference(stored, view, picture, search);
    if (!reference)
      throw std::runtime_error(
          "the stored object was not found in the new picture, so the new view cannot share its "
          "frame; show it more like the stored views, or use --overwrite");
    view.reference = *reference;
    stored.views.push_back(view);
  });
}

void store(ObjectLibrary& library, const Arguments& arguments, const Lesson& lesson,
           const SearchConfig& search, LearnResult& result) {
  using Existing = ObjectLibrary::Existing;
  try {
    result.object =
        arguments.has("--add-view")
            ? add_view(library, result, lesson.before, search)
            : library.save(result.object,
                           arguments.has("--overwrite") ? Existing::kReplace : Existing::kRefuse);
    result.error = LearnError::kSuccess;
  } catch (const FileError& error) {
    refuse(result, LearnError::kStorage, error.what());
  }
}

LearnResult learn_and_store(const Arguments& arguments, Settings& settings) {
  const Lesson lesson = lesson_from(arguments);
  if (arguments.has("--method"))
    assign_field(field_rows(settings.lesson()), "method", arguments.get("--method"));
  StageWriter stages(arguments.get("--stages"));
  ObjectLibrary library(arguments.get("--library"));
  LearnResult result;
  result.object.name = lesson.name;
  refuse(result, check_name(arguments, library));
  if (result.error != LearnError::kSuccess) return result;
  result = learn_object(lesson, settings.lesson(), settings.search(), stages.observer());
  result.object.name = lesson.name;
  if (may_store(result, arguments)) store(library, arguments, lesson, settings.search(), result);
  return result;
}

ExitCode run(const Arguments& arguments) {
  check_lesson_arguments(arguments);
  Settings settings = settings_from(arguments);
  const LearnResult result = learn_and_store(arguments, settings);
  if (arguments.has("--json")) write_lesson(std::cout, result);
  if (result.error == LearnError::kSuccess) {
    if (!arguments.has("--json")) print_lesson(std::cout, result);
    return kDone;
  }
  std::cerr << "mbncc: '" << result.object.name << "' was not stored: " << result.message << ' '
            << result.hint << '\n';
  return kFailed;
}

}  // namespace

Command learn_command() {
  return {
      "learn",
      "learn an object from pictures and store it",
      lesson_options(),
      "",
      "Where the object is, is said by --after (a second picture without it), --roi, or --map.\n"
      "A verdict GOOD or MARGINAL is stored, BAD only with --allow-bad; --map is never refused\n"
      "for quality. Stored revisions that are replaced go to DIR/.trash.\n",
      run};
}

}  // namespace mbncc::cli
