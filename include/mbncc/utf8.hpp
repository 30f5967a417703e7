// SPDX-License-Identifier: BSD-3-Clause
// Validation of external text: names of files, labels.
#pragma once

#include <cstddef>
#include <string_view>

namespace mbncc {

/// Bytes of the character that `text` begins with, 1 to 4; 0 if it does not begin with well-formed
/// UTF-8 (RFC 3629: no overlong forms, no surrogates), or is empty.
std::size_t utf8_length(std::string_view text);

}  // namespace mbncc
