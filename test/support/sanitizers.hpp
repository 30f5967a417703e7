// What tests do differently when they are built with sanitizers.
#pragma once

#include <opencv2/core/utility.hpp>

namespace mbncc::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  ///< memory is no measure: sanitizers keep what is freed
#else
constexpr bool kSanitized = false;
#endif

/// OpenCV's own threads are not instrumented: what they hand over would be reported as races.
inline void do_without_uninstrumented_threads() {
  if (kSanitized) cv::setNumThreads(1);
}

}  // namespace mbncc::test
