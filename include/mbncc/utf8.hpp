// SPDX-License-Identifier: BSD-3-Clause
// Validation of external text: file names and labels.
#pragma once

#include <cstddef>
#include <string_view>

namespace mbncc {

/// Number of bytes, 1 to 4, of the character at the start of `text`; 0 if `text` is empty or does
/// not start with well-formed UTF-8 (RFC 3629: no overlong forms, no surrogates).
std::size_t utf8_length(std::string_view text);

}  // namespace mbncc
