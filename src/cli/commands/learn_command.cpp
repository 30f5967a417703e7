// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>

#include "cli/command.hpp"
#include "cli/lesson_arguments.hpp"
#include "cli/library_access.hpp"
#include "cli/report/lesson_report.hpp"
#include "cli/report/stage_writer.hpp"
#include "cli/settings.hpp"
#include "cli/terminal/progress.hpp"
#include "mbncc/error.hpp"
#include "mbncc/learning/further_view.hpp"
#include "mbncc/learning/interactive_lesson.hpp"
#include "mbncc/learning/lesson_storage.hpp"
#include "mbncc/learning/resemblance.hpp"
#include "mbncc/library/object_file.hpp"

namespace mbncc::cli {
namespace {

Lesson read_lesson(const Arguments& arguments) {
  try {
    return lesson_from(arguments);
  } catch (const FileError& error) {
    Refusal refusal(LearnError::kNoImage, std::string(error.what()) + ".");
    refusal.hint.clear();  // the message of the FileError already says what to do
    throw refusal;
  }
}

Storing storing_of(const Arguments& arguments) {
  if (arguments.has("--add-view")) return Storing::kAddView;
  return arguments.has("--overwrite") ? Storing::kReplace : Storing::kNew;
}

bool may_store(const LearnResult& result, const Arguments& arguments) {
  return result.has_model && (result.error == LearnError::kSuccess || arguments.has("--allow-bad"));
}

ObjectModel store(ObjectLibrary& library, Storing storing, const ObjectModel& learned,
                  const cv::Mat& image, const SearchConfig& search) {
  using Existing = ObjectLibrary::Existing;
  try {
    if (storing != Storing::kAddView)
      return library.save(learned,
                          storing == Storing::kReplace ? Existing::kReplace : Existing::kRefuse);
    return library.edit(learned.name, [&](ObjectModel& stored) {
      if (const auto refusal = add_view(stored, learned, image, search)) throw *refusal;
    });
  } catch (const std::exception& failure) {
    throw Refusal(failure);
  }
}

// The result of a correction replaces that of the lesson; if the correction fails, nothing is
// stored.
LearnResult learn(const Lesson& lesson, const std::optional<LessonEdit>& edit, Settings& settings,
                  const StageObserver& observer) {
  InteractiveLesson learned(lesson, settings.lesson(), settings.search(), observer);
  if (!edit || !learned.result().has_model) return learned.result();
  return learned.edit(*edit, observer);
}

void learn_and_store(const Arguments& arguments, Settings& settings, LearnResult& result) {
  const auto edit = edit_from(arguments);
  const Lesson lesson = read_lesson(arguments);
  StageWriter stages(arguments.get("--stages"),
                     {arguments.get("--before"), arguments.get("--after"), arguments.get("--map")});
  ObjectLibrary library(library_folder(arguments));
  const auto known = load_reporting(library);
  const Storing storing = storing_of(arguments);
  // Checked before the lesson, so that a lesson that cannot be stored is not computed.
  if (const auto refusal = check_storing(lesson, storing, *known)) throw *refusal;
  {
    Progress progress("", 1);
    result = learn(lesson, edit, settings, stages.observer(progress));
  }
  stages.tell();
  if (!may_store(result, arguments)) return;
  note_resemblance(result.object, lesson.before, known->objects, settings.search());
  result.object = store(library, storing, result.object, lesson.before, settings.search());
  if (result.error == LearnError::kSuccess) return;
  result.error = LearnError::kSuccess;  // a BAD one that was to be stored
  result.message = message_of(result.error);
  result.hint = hint_of(result.error);
}

void refuse(const Refusal& refusal, LearnResult& result) {
  result.error = refusal.error;
  result.message = refusal.message;
  result.hint = refusal.hint;
}

/// The core's hints name fields of a goal; here, the corresponding options are named.
std::string in_options(std::string hint) {
  const std::pair<const char*, const char*> options[] = {
      {"overwrite", "--overwrite"}, {"add_view", "--add-view"}, {"allow_bad", "--allow-bad"}};
  for (const auto& [field, option] : options) {
    const auto at = hint.find(field);
    if (at != std::string::npos) hint.replace(at, std::string(field).size(), option);
  }
  return hint;
}

LearnResult result_of(const Arguments& arguments, Settings& settings) {
  LearnResult result;
  try {
    learn_and_store(arguments, settings, result);
  } catch (const Refusal& refusal) {
    refuse(refusal, result);
  } catch (const FileError& failure) {
    refuse(Refusal(failure), result);
  }
  result.object.name = arguments.get("--name");
  result.hint = in_options(result.hint);
  return result;
}

ExitCode run(const Arguments& arguments) {
  check_lesson_arguments(arguments);
  Settings settings = settings_from(arguments);
  if (arguments.has("--method"))
    assign_field(field_rows(settings.lesson()), "method", arguments.get("--method"));
  const LearnResult result = result_of(arguments, settings);
  const bool stored = result.error == LearnError::kSuccess;
  const std::string file = stored ? std::filesystem::path(library_folder(arguments)) /
                                        (result.object.name + kObjectFileEnding)
                                  : std::filesystem::path();
  if (arguments.has("--json")) write_lesson(std::cout, result, file);
  if (stored) {
    if (!arguments.has("--json")) print_lesson(std::cout, result, file);
    return kDone;
  }
  std::cerr << "mbncc: '" << result.object.name << "' was not stored: " << result.message
            << (result.hint.empty() ? "" : " ") << result.hint << '\n';
  return kFailed;
}

}  // namespace

Command learn_command() {
  return {"learn",
          "learn an object from images and store it",
          lesson_options(),
          "",
          "--after (a second image without the object), --roi, --click or --map give the "
          "object's\n place. Strokes by --include and --exclude correct the outline.\n"
          "A verdict GOOD or MARGINAL is stored, BAD only with --allow-bad; --map is never "
          "refused\n for quality. Replaced revisions go to DIR/.trash.\n",
          run};
}

}  // namespace mbncc::cli
