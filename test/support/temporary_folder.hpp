// SPDX-License-Identifier: BSD-3-Clause
// A folder that is removed when the test ends.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace mbncc::test {

class TemporaryFolder {
 public:
  TemporaryFolder() : path_((parent() / "mbncc_XXXXXX").string()) {
    if (::mkdtemp(path_.data()) == nullptr) throw std::runtime_error("no temporary folder");
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  // Uses a memory file system if there is one, because syncing costs nothing there.
  static std::filesystem::path parent() {
    const std::filesystem::path memory = "/dev/shm";
    const bool writable = ::access(memory.c_str(), W_OK | X_OK) == 0;
    return writable ? memory : std::filesystem::temp_directory_path();
  }

  std::string path_;
};

}  // namespace mbncc::test
