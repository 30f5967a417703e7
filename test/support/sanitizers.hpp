// SPDX-License-Identifier: BSD-3-Clause
// Differences of tests built with sanitizers.
#pragma once

namespace mbncc::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;  ///< memory is no measure: sanitizers keep what is freed
#else
constexpr bool kSanitized = false;
#endif

}  // namespace mbncc::test
