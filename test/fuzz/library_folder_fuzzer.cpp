// SPDX-License-Identifier: BSD-3-Clause
// Library folders with files of any name and content, including links and folders. Loading must not
// fail, it must be possible to store the loaded objects again, and no file outside the folder may
// change.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <vector>

#include "fuzz/fuzzer.hpp"
#include "mbncc/error.hpp"
#include "mbncc/library/object_file.hpp"
#include "mbncc/library/object_library.hpp"
#include "support/settled_file.hpp"
#include "support/temporary_folder.hpp"

using namespace mbncc;

namespace {

// A valid object under the given name.
std::vector<std::uint8_t> sound_object(std::uint32_t revision) {
  View view;
  view.template_image = cv::Mat::zeros(6, 5, CV_8UC3);
  view.map = cv::Mat(6, 5, CV_8UC1, cv::Scalar(255));
  view.image_size = {640, 480};
  ObjectModel model;
  model.name = model.label = "sound";
  model.revision = revision + 1;
  model.views = {view};
  return encode_object(model);
}

std::string file_name_from(fuzz::Pieces& pieces) {
  std::string name = pieces.text(pieces.byte() % 80);
  for (char& letter : name)
    if (letter == '/' || letter == '\0') letter = '_';
  return name.empty() || name == "." || name == ".." ? "x.png" : name;
}

void add_entry(const std::string& folder, fuzz::Pieces& pieces) {
  const int kind = pieces.byte() % 6;
  const std::string path = folder + "/" + file_name_from(pieces);
  if (kind == 0) {
    ::mkdir(path.c_str(), 0755);
  } else if (kind == 1) {
    if (::symlink("/etc/passwd", path.c_str()) != 0) return;
  } else if (kind == 2) {
    ::mkfifo(path.c_str(), 0644);
  } else {
    const auto bytes = sound_object(pieces.byte());
    const std::string content = kind == 3 ? std::string(bytes.begin(), bytes.end())
                                          : pieces.text(pieces.byte() * std::size_t{4});
    std::ofstream(path, std::ios::binary) << content;
  }
  test::settle(path);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::TemporaryFolder parent;
  const std::string folder = parent / "library";
  ::mkdir(folder.c_str(), 0755);
  fuzz::Pieces pieces(data, size);
  for (int entries = 0; entries < 8 && !pieces.empty(); ++entries) add_entry(folder, pieces);
  ObjectLibrary library(folder);
  const auto snapshot = library.load();
  for (const auto& object : snapshot->objects) {
    if (object->revision > 8) fuzz::planted_bug(snapshot->objects.size());
    try {
      library.save(*object, ObjectLibrary::Existing::kReplace);
    } catch (const FileError&) {  // a folder has the object's name
    }
  }
  std::size_t outside = 0;
  for (const auto& entry : std::filesystem::directory_iterator(parent.path()))
    outside += entry.path() == folder ? 0 : 1;
  if (outside != 0) std::abort();
  return 0;
}
