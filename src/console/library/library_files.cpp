// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_files.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <map>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <utility>

#include "mbncc/library/object_file.hpp"
#include "mbncc/library/object_library.hpp"

namespace mbncc::console {
namespace {

namespace fs = std::filesystem;

constexpr double kSameTime = 1e-3;  // [s] rounding of a time in messages

/// Whether the folder holds this revision of the object.
bool holds(const std::string& folder, const mbncc_vision::LearnedObject& object) {
  try {
    const ObjectModel here = read_object_file(folder + "/" + object.name + kObjectFileEnding);
    return here.revision == object.revision &&
           std::abs(here.learned_at - object.learned_at.toSec()) < kSameTime;
  } catch (const std::exception&) {
    return false;
  }
}

std::string date_of(double seconds) {
  const auto time = static_cast<std::time_t>(seconds);
  std::tm parts{};
  ::localtime_r(&time, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

Revision revision_of(const ObjectModel& model) {
  Revision revision;
  revision.name = model.name;
  revision.number = model.revision;
  cv::cvtColor(model.views.front().template_image, revision.image, cv::COLOR_BGR2RGB);
  revision.text = "revision " + std::to_string(model.revision) + ", " + date_of(model.learned_at) +
                  ", " + std::to_string(model.views.size()) + " view(s), " +
                  to_string(model.quality.verdict);
  return revision;
}

/// Revisions of the objects named `wanted`, newest first; unreadable files are left out.
std::vector<Revision> trash_of(const ListedLibrary& library,
                               const std::function<bool(const std::string&)>& wanted) {
  check_library(library);
  std::vector<Revision> revisions;
  const fs::path trash = fs::path(library.folder) / ".trash";
  if (!fs::is_directory(trash)) return revisions;
  for (const auto& entry : fs::directory_iterator(trash)) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() != kObjectFileEnding || !wanted(file.substr(0, file.find('.'))))
      continue;
    try {
      revisions.push_back(revision_of(read_object_file(entry.path().string())));
    } catch (const std::exception&) {
      continue;
    }
  }
  std::sort(revisions.begin(), revisions.end(),
            [](const Revision& a, const Revision& b) { return a.number > b.number; });
  return revisions;
}

}  // namespace

void check_library(const ListedLibrary& library) {
  const std::string& folder = library.folder;
  if (folder.empty())
    throw std::runtime_error(
        "The learning nodelet has not named the library's folder yet; wait until its lamp shows "
        "the library.");
  if (!fs::is_directory(folder))
    throw std::runtime_error("The library's folder " + folder +
                             " is not on this computer; use the cell's computer.");
  // The objects tell apart computers whose disks are copies of each other.
  const bool same = library.inode == folder_inode(folder) &&
                    std::all_of(library.objects.begin(), library.objects.end(),
                                [&](const auto& object) { return holds(folder, object); });
  if (!same)
    throw std::runtime_error("The folder " + folder +
                             " on this computer is not the cell's library; use the cell's "
                             "computer, or try again if the library has just changed.");
}

void export_object(const ListedLibrary& library, const std::string& name, const std::string& file) {
  check_library(library);
  const std::string stored = library.folder + "/" + name + kObjectFileEnding;
  read_object_file(stored);  // only valid objects are exported
  fs::copy_file(stored, file, fs::copy_options::overwrite_existing);
}

std::string import_object(const ListedLibrary& library, const std::string& file) {
  check_library(library);
  ObjectModel model = read_object_file(file);
  if (!is_valid_name(model.name))
    throw std::runtime_error("The file's name becomes the object's name: '" + model.name +
                             "' is not valid; rename the file.");
  return ObjectLibrary(library.folder).save(model, ObjectLibrary::Existing::kRefuse).name;
}

std::vector<Revision> earlier_revisions(const ListedLibrary& library, const std::string& name) {
  return trash_of(library, [&](const std::string& of) { return of == name; });
}

std::vector<Revision> deleted_objects(const ListedLibrary& library) {
  std::map<std::string, Revision> newest;
  const auto is_gone = [&](const std::string& name) {
    return !fs::exists(fs::path(library.folder) / (name + kObjectFileEnding));
  };
  for (auto& revision : trash_of(library, is_gone))
    newest.try_emplace(revision.name, std::move(revision));
  std::vector<Revision> objects;
  for (auto& [name, revision] : newest) objects.push_back(std::move(revision));
  return objects;
}

}  // namespace mbncc::console
