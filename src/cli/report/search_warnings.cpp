// SPDX-License-Identifier: BSD-3-Clause
#include "cli/report/search_warnings.hpp"

#include <algorithm>
#include <iostream>

namespace mbncc::cli {

void warn_of_skipped(const std::string& image_path, const SearchResult& result) {
  for (const auto& reason : result.skipped)
    std::cerr << "mbncc: warning: " << image_path << ": not searched " << reason << '\n';
}

void warn_of_other_size(const std::string& image_path, cv::Size size,
                        const LibrarySnapshot& library, const std::vector<std::string>& names) {
  std::string first;
  int more = -1;
  for (const auto& object : library.objects) {
    const bool wanted =
        names.empty() || std::find(names.begin(), names.end(), object->name) != names.end();
    const std::string reason = other_image_size(*object, size);
    if (!wanted || !object->enabled || reason.empty()) continue;
    if (first.empty()) first = object->name + " was " + reason;
    ++more;
  }
  if (first.empty()) return;
  std::cerr << "mbncc: warning: " << image_path << ": " << first
            << ", unless it is a crop of such an image"
            << (more > 0 ? "; so were " + std::to_string(more) + " more objects\n" : "\n");
}

}  // namespace mbncc::cli
