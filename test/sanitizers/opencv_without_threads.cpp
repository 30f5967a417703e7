// SPDX-License-Identifier: BSD-3-Clause
// Used to run a part of the core under ThreadSanitizer: OpenCV's own threads synchronise inside
// libtbb, which ThreadSanitizer does not see. The package's threads are not affected.
#include <opencv2/core/utility.hpp>

namespace {

[[maybe_unused]] const bool without_threads = (cv::setNumThreads(0), true);

}  // namespace
