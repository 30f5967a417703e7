// SPDX-License-Identifier: BSD-3-Clause
// Export and import of objects as single files; earlier revisions and deleted objects. Works only
// if this computer has access to the library's folder.
#pragma once

#include <mbncc_vision/LearnedObject.h>

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace mbncc::console {

/// One revision in the trash.
struct Revision {
  std::string name;  ///< of the object
  std::uint32_t number = 0;
  cv::Mat image;     ///< CV_8UC3 rgb, the first view
  std::string text;  ///< when it was learned, views, verdict
};

/// The library as the learning nodelet lists it.
struct ListedLibrary {
  std::string folder;  ///< "": unknown
  std::uint64_t inode = 0;
  std::vector<mbncc_vision::LearnedObject> objects;
};

/// Throws a std::exception with a message unless this computer's folder of that path is the one
/// that the nodelet uses: another computer may have a folder of the same path, or a copy.
void check_library(const ListedLibrary& library);

/// These functions check the library first. They throw std::exceptions with a message.
void export_object(const ListedLibrary& library, const std::string& name, const std::string& file);

/// Returns the object's name in the library; refuses an existing name.
std::string import_object(const ListedLibrary& library, const std::string& file);

/// Newest first; unreadable files are left out.
std::vector<Revision> earlier_revisions(const ListedLibrary& library, const std::string& name);

/// The newest readable revision of every object that exists only in the trash, by name.
std::vector<Revision> deleted_objects(const ListedLibrary& library);

}  // namespace mbncc::console
