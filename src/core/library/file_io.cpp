// SPDX-License-Identifier: BSD-3-Clause
#include "library/file_io.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <system_error>

namespace mbncc::library {
namespace {

constexpr mode_t kFileMode = 0644;
constexpr mode_t kFolderMode = 0755;
constexpr std::int64_t kRecent_ns = 5'000'000'000;  // longer than a copy pauses between two writes

[[noreturn]] void fail(const std::string& path, const char* what, int code) {
  throw FileError(path, std::string(what) + ": " + errno_text(code));
}

template <class Call>
auto repeat_interrupted(Call&& call) {
  auto result = call();
  while (result < 0 && errno == EINTR) result = call();
  return result;
}

std::int64_t nanoseconds(const timespec& time) {
  return std::int64_t{time.tv_sec} * 1000000000 + time.tv_nsec;
}

void write_all(int descriptor, const std::vector<std::uint8_t>& bytes, const std::string& path) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = repeat_interrupted(
        [&] { return ::write(descriptor, bytes.data() + done, bytes.size() - done); });
    if (count <= 0) fail(path, "cannot write", count < 0 ? errno : EIO);
    done += static_cast<std::size_t>(count);
  }
}

void sync_file(int descriptor, const std::string& path) {
  if (repeat_interrupted([&] { return ::fsync(descriptor); }) != 0)
    fail(path, "cannot be synced to disk", errno);
}

// A temporary file that is removed unless it has been renamed to its final name.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::string& folder)
      : path_(folder + "/" + kTemporaryPrefix + "XXXXXX"),
        file_(::mkostemp(path_.data(), O_CLOEXEC)) {
    if (!file_.is_open()) fail(folder, "cannot create a file here", errno);
  }
  ~TemporaryFile() {
    if (!kept_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(const std::vector<std::uint8_t>& bytes, const std::string& final_path) {
    write_all(file_.get(), bytes, final_path);
    if (::fchmod(file_.get(), kFileMode) != 0) fail(final_path, "cannot set its mode", errno);
    sync_file(file_.get(), final_path);
    if (const int code = file_.close()) fail(final_path, "cannot write", code);
  }

  void rename_to(const std::string& final_path) {
    rename_path(path_, final_path);
    kept_ = true;
  }

 private:
  std::string path_;
  FileDescriptor file_;
  bool kept_ = false;
};

void read_all(int descriptor, FileContent& content, const std::string& path) {
  std::size_t done = 0;
  while (done < content.bytes.size()) {
    const ssize_t count = repeat_interrupted([&] {
      return ::read(descriptor, content.bytes.data() + done, content.bytes.size() - done);
    });
    if (count < 0) fail(path, "cannot read", errno);
    if (count == 0) throw ContentError(path, "the file became shorter while it was read");
    done += static_cast<std::size_t>(count);
  }
}

}  // namespace

std::string errno_text(int code) {
  return std::generic_category().message(code);
}

FileDescriptor::~FileDescriptor() {
  close();
}

int FileDescriptor::close() {
  if (descriptor_ < 0) return 0;
  // close() is not repeated after EINTR, because Linux has already released the descriptor.
  const int result = ::close(descriptor_);
  descriptor_ = -1;
  return result != 0 && errno != EINTR ? errno : 0;
}

FileStamp::FileStamp(const struct stat& status)
    : device(status.st_dev),
      inode(status.st_ino),
      size(status.st_size),
      modified_ns(nanoseconds(status.st_mtim)),
      changed_ns(nanoseconds(status.st_ctim)) {}

bool FileStamp::operator==(const FileStamp& other) const {
  return device == other.device && inode == other.inode && size == other.size &&
         modified_ns == other.modified_ns && changed_ns == other.changed_ns;
}

// The clock of a file server may be slightly ahead.
bool changed_recently(const FileStamp& stamp) {
  timespec now{};
  ::clock_gettime(CLOCK_REALTIME, &now);
  return std::abs(nanoseconds(now) - stamp.modified_ns) < kRecent_ns;
}

FileContent read_regular_file(const std::string& path, std::size_t max_bytes) {
  // With O_NONBLOCK, opening a FIFO does not wait for a writer.
  const FileDescriptor file(repeat_interrupted(
      [&] { return ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC); }));
  if (!file.is_open()) {
    if (errno == ELOOP) throw ContentError(path, "a symbolic link is not accepted here");
    if (errno == ENXIO) throw ContentError(path, "not a regular file");
    fail(path, "cannot open", errno);
  }
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) fail(path, "cannot read", errno);
  if (!S_ISREG(status.st_mode)) throw ContentError(path, "not a regular file");
  if (static_cast<std::uint64_t>(status.st_size) > max_bytes)
    throw ContentError(path, "too large: " + std::to_string(status.st_size) + " bytes, at most " +
                                 std::to_string(max_bytes) + " are read");
  FileContent content{std::vector<std::uint8_t>(static_cast<std::size_t>(status.st_size)),
                      FileStamp(status)};
  read_all(file.get(), content, path);
  return content;
}

void write_file_atomically(const std::string& folder, const std::string& name,
                           const std::vector<std::uint8_t>& bytes) {
  const std::string path = folder + "/" + name;
  FolderSync folder_sync(folder);
  TemporaryFile temporary(folder);
  temporary.write(bytes, path);
  temporary.rename_to(path);
  folder_sync.sync();
}

void try_to_write(const std::string& folder, std::size_t bytes) {
  TemporaryFile(folder).write(std::vector<std::uint8_t>(bytes), folder);
}

void remove_temporaries(const std::string& folder) {
  for (const auto& name : entries_of(folder)) {
    const std::string path = folder + "/" + name;
    struct stat status {};
    if (name.rfind(kTemporaryPrefix, 0) == 0 && ::lstat(path.c_str(), &status) == 0 &&
        S_ISREG(status.st_mode))
      ::unlink(path.c_str());
  }
}

FolderSync::FolderSync(const std::string& folder)
    : folder_(folder), file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (!file_.is_open()) fail(folder, "cannot open", errno);
}

void FolderSync::sync() {
  // Some network file systems cannot sync folders and return EINVAL.
  const int result = repeat_interrupted([&] { return ::fsync(file_.get()); });
  if (result != 0 && errno != EINVAL)
    fail(folder_, "the change is made but not yet synced to disk", errno);
}

void make_folder(const std::string& folder) {
  if (::mkdir(folder.c_str(), kFolderMode) == 0) return;
  int code = errno;
  const std::string parent = std::filesystem::path(folder).parent_path().string();
  if ((code == ENOENT || code == ENOTDIR) && !parent.empty()) {
    make_folder(parent);
    if (::mkdir(folder.c_str(), kFolderMode) == 0) return;
    code = errno;
  }
  struct stat status {};
  if (::stat(folder.c_str(), &status) != 0) fail(folder, "cannot create the folder", code);
  if (!S_ISDIR(status.st_mode)) throw FileError(folder, "is a file; give a folder");
}

bool is_inner_folder(const std::string& folder) {
  struct stat status {};
  if (::lstat(folder.c_str(), &status) != 0) {
    if (errno == ENOENT) return false;
    fail(folder, "cannot open", errno);
  }
  if (!S_ISDIR(status.st_mode))
    throw FileError(
        folder,
        "not a folder of the library's own, but a link or a file; move it away, and the "
        "library makes a folder");
  return true;
}

void make_inner_folder(const std::string& folder) {
  if (!is_inner_folder(folder)) make_folder(folder);
}

void rename_path(const std::string& from, const std::string& to) {
  if (::rename(from.c_str(), to.c_str()) != 0) fail(to, "cannot put the file in place", errno);
}

std::optional<FileStamp> stamp_of(const std::string& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return std::nullopt;
  return FileStamp(status);
}

bool path_exists(const std::string& path) {
  return stamp_of(path).has_value();
}

std::vector<std::string> entries_of(const std::string& folder) {
  const std::unique_ptr<DIR, int (*)(DIR*)> stream(::opendir(folder.c_str()), ::closedir);
  if (!stream) fail(folder, "cannot list the folder", errno);
  std::vector<std::string> names;
  errno = 0;
  while (const dirent* entry = ::readdir(stream.get())) names.emplace_back(entry->d_name);
  if (errno != 0) fail(folder, "cannot list the folder", errno);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace mbncc::library
