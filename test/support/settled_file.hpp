// SPDX-License-Identifier: BSD-3-Clause
// The library takes a damaged file that was changed in the last seconds for one that is still being
// copied.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>

#include <stdexcept>
#include <string>

namespace mbncc::test {

/// Dates a file's last change back by a minute; of a link, not of its target.
inline void settle(const std::string& path) {
  timespec times[2] = {{0, UTIME_OMIT}, {0, 0}};
  ::clock_gettime(CLOCK_REALTIME, &times[1]);
  times[1].tv_sec -= 60;
  if (::utimensat(AT_FDCWD, path.c_str(), times, AT_SYMLINK_NOFOLLOW) != 0)
    throw std::runtime_error("cannot date " + path);
}

}  // namespace mbncc::test
