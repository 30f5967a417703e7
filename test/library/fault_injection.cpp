// SPDX-License-Identifier: BSD-3-Clause
#include "library/fault_injection.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>

namespace mbncc::test {

FaultPlan& fault_plan() {
  static FaultPlan plan;
  return plan;
}

namespace {

// True if this call is to fail; errno is set.
bool goes_wrong(const char* call) {
  FaultPlan& plan = fault_plan();
  if (!plan.armed) return false;
  plan.calls.emplace_back(call);
  if (static_cast<int>(plan.calls.size()) - 1 != plan.at) return false;
  if (plan.die) ::_exit(9);
  if (plan.meanwhile) {
    plan.armed = false;
    plan.meanwhile();
    plan.armed = true;
  }
  if (plan.error == 0) return false;
  errno = plan.error;
  return true;
}

ino_t inode_of(const std::string& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

ino_t inode_of(int file) {
  struct stat status {};
  return ::fstat(file, &status) == 0 ? status.st_ino : 0;
}

std::string folder_of(const std::string& path) {
  return path.substr(0, path.find_last_of('/'));
}

// Records that an entry of a folder was created or removed.
void note_entry(const std::string& path) {
  if (fault_plan().armed) fault_plan().unsafe_names.insert(inode_of(folder_of(path)));
}

void note_name(const std::string& path) {
  FaultPlan& plan = fault_plan();
  if (!plan.armed) return;
  note_entry(path);
  if (plan.unsafe_data.count(inode_of(path)) > 0) plan.hasty.push_back(path);
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace mbncc::test

using mbncc::test::fault_plan;
using mbncc::test::goes_wrong;
using mbncc::test::inode_of;
using mbncc::test::note_entry;
using mbncc::test::note_name;
using mbncc::test::real;

extern "C" {

int open(const char* path, int flags, ...) {
  if (goes_wrong("open")) return -1;
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  return real<int(const char*, int, ...)>("open")(path, flags, mode);
}

int mkostemp(char* pattern, int flags) {
  return goes_wrong("mkostemp") ? -1 : real<int(char*, int)>("mkostemp")(pattern, flags);
}

ssize_t write(int file, const void* bytes, size_t count) {
  if (goes_wrong("write")) return -1;
  if (fault_plan().armed && fault_plan().short_write && count > 1) count = 1 + count / 3;
  if (fault_plan().armed) fault_plan().unsafe_data.insert(inode_of(file));
  return real<ssize_t(int, const void*, size_t)>("write")(file, bytes, count);
}

int fchmod(int file, mode_t mode) {
  return goes_wrong("fchmod") ? -1 : real<int(int, mode_t)>("fchmod")(file, mode);
}

int fsync(int file) {
  if (goes_wrong("fsync")) return -1;
  fault_plan().unsafe_data.erase(inode_of(file));
  fault_plan().unsafe_names.erase(inode_of(file));
  return real<int(int)>("fsync")(file);
}

// The descriptor is closed, whatever close() returns.
int close(int file) {
  const int result = real<int(int)>("close")(file);
  return goes_wrong("close") ? -1 : result;
}

int rename(const char* from, const char* to) noexcept {
  if (goes_wrong("rename")) return -1;
  const int result = real<int(const char*, const char*)>("rename")(from, to);
  if (result == 0) note_entry(from);
  if (result == 0) note_name(to);
  return result;
}

int link(const char* from, const char* to) noexcept {
  if (goes_wrong("link")) return -1;
  const int result = real<int(const char*, const char*)>("link")(from, to);
  if (result == 0) note_name(to);
  return result;
}

int mkdir(const char* path, mode_t mode) noexcept {
  if (goes_wrong("mkdir")) return -1;
  const int result = real<int(const char*, mode_t)>("mkdir")(path, mode);
  if (result == 0) note_entry(path);
  return result;
}

int flock(int file, int operation) noexcept {
  return goes_wrong("flock") ? -1 : real<int(int, int)>("flock")(file, operation);
}

}  // extern "C"
