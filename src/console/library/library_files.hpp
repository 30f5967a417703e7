// SPDX-License-Identifier: BSD-3-Clause
// Export and import of objects as single files; earlier revisions and deleted objects. Works only
// if the library's folder is on this computer.
#pragma once

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

/// These functions throw std::exceptions with a message; `folder` is the library's.
void export_object(const std::string& folder, const std::string& name, const std::string& file);

/// Returns the object's name in the library; refuses an existing name.
std::string import_object(const std::string& folder, const std::string& file);

/// Newest first; unreadable files are left out.
std::vector<Revision> earlier_revisions(const std::string& folder, const std::string& name);

/// The newest readable revision of every object that exists only in the trash, by name.
std::vector<Revision> deleted_objects(const std::string& folder);

}  // namespace mbncc::console
