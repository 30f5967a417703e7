// SPDX-License-Identifier: BSD-3-Clause
// Part of the core under ThreadSanitizer: OpenCV's own threads meet inside libtbb, whose
// synchronisation it does not see. The package's threads are not touched.
#include <opencv2/core/utility.hpp>

namespace {

[[maybe_unused]] const bool without_threads = (cv::setNumThreads(0), true);

}  // namespace
