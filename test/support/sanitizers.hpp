// SPDX-License-Identifier: BSD-3-Clause
// Differences of tests that are built with sanitizers.
#pragma once

namespace mbncc::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  ///< memory use is meaningless: sanitizers keep freed memory
#else
constexpr bool kSanitized = false;
#endif

}  // namespace mbncc::test
