// SPDX-License-Identifier: BSD-3-Clause
// Objects as single files: exported, imported, and their earlier revisions. Works where the
// library's folder is on this computer.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace mbncc::console {

/// One revision in the trash.
struct Revision {
  std::uint32_t number = 0;
  cv::Mat picture;   ///< CV_8UC3 rgb, the first view
  std::string text;  ///< when it was learned, views, verdict
};

/// Those functions throw std::exceptions with a sentence; `folder` is the library's.
void export_object(const std::string& folder, const std::string& name, const std::string& file);

/// Returns the name it has in the library; one that is taken is refused.
std::string import_object(const std::string& folder, const std::string& file);

/// Newest first; files that cannot be read are left out.
std::vector<Revision> earlier_revisions(const std::string& folder, const std::string& name);

}  // namespace mbncc::console
