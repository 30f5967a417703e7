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

// True when this call is the one that goes wrong; errno is set.
bool goes_wrong(const char* call) {
  FaultPlan& plan = fault_plan();
  if (!plan.armed) return false;
  plan.calls.emplace_back(call);
  if (static_cast<int>(plan.calls.size()) - 1 != plan.at) return false;
  if (plan.die) ::_exit(9);
  if (plan.error == 0) return false;
  errno = plan.error;
  return true;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace
}  // namespace mbncc::test

using mbncc::test::fault_plan;
using mbncc::test::goes_wrong;
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
  return real<ssize_t(int, const void*, size_t)>("write")(file, bytes, count);
}

int fchmod(int file, mode_t mode) {
  return goes_wrong("fchmod") ? -1 : real<int(int, mode_t)>("fchmod")(file, mode);
}

int fsync(int file) {
  return goes_wrong("fsync") ? -1 : real<int(int)>("fsync")(file);
}

int rename(const char* from, const char* to) noexcept {
  return goes_wrong("rename") ? -1 : real<int(const char*, const char*)>("rename")(from, to);
}

int link(const char* from, const char* to) noexcept {
  return goes_wrong("link") ? -1 : real<int(const char*, const char*)>("link")(from, to);
}

int mkdir(const char* path, mode_t mode) noexcept {
  return goes_wrong("mkdir") ? -1 : real<int(const char*, mode_t)>("mkdir")(path, mode);
}

int flock(int file, int operation) noexcept {
  return goes_wrong("flock") ? -1 : real<int(int, int)>("flock")(file, operation);
}

}  // extern "C"
