// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/home_folder.hpp"

#include <cstdlib>

#include "mbncc/error.hpp"

namespace mbncc {

std::string expand_home(const std::string& path) {
  const bool at_home = path == "~" || path.rfind("~/", 0) == 0;
  if (!at_home) return path;
  const char* home = std::getenv("HOME");
  if (home == nullptr || *home == '\0')
    throw FileError(path, "HOME is not set; give --library or library_path without ~");
  return home + path.substr(1);
}

}  // namespace mbncc
