// SPDX-License-Identifier: BSD-3-Clause
#include "console/library/library_files.hpp"

#include <algorithm>
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

void check_folder(const std::string& folder) {
  if (folder.empty() || !fs::is_directory(folder))
    throw std::runtime_error("The library's folder " + folder +
                             " is not on this computer; use the cell's computer.");
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
std::vector<Revision> trash_of(const std::string& folder,
                               const std::function<bool(const std::string&)>& wanted) {
  check_folder(folder);
  std::vector<Revision> revisions;
  const fs::path trash = fs::path(folder) / ".trash";
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

void export_object(const std::string& folder, const std::string& name, const std::string& file) {
  check_folder(folder);
  read_object_file(folder + "/" + name + kObjectFileEnding);  // only valid objects are exported
  fs::copy_file(folder + "/" + name + kObjectFileEnding, file,
                fs::copy_options::overwrite_existing);
}

std::string import_object(const std::string& folder, const std::string& file) {
  check_folder(folder);
  ObjectModel model = read_object_file(file);
  if (!is_valid_name(model.name))
    throw std::runtime_error("The file's name becomes the object's name: '" + model.name +
                             "' is not valid; rename the file.");
  return ObjectLibrary(folder).save(model, ObjectLibrary::Existing::kRefuse).name;
}

std::vector<Revision> earlier_revisions(const std::string& folder, const std::string& name) {
  return trash_of(folder, [&](const std::string& of) { return of == name; });
}

std::vector<Revision> deleted_objects(const std::string& folder) {
  std::map<std::string, Revision> newest;
  const auto is_gone = [&](const std::string& name) {
    return !fs::exists(fs::path(folder) / (name + kObjectFileEnding));
  };
  for (auto& revision : trash_of(folder, is_gone))
    newest.try_emplace(revision.name, std::move(revision));
  std::vector<Revision> objects;
  for (auto& [name, revision] : newest) objects.push_back(std::move(revision));
  return objects;
}

}  // namespace mbncc::console
