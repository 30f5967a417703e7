// SPDX-License-Identifier: BSD-3-Clause
// Rules for displayed text: labels of objects and names of frames.
#pragma once

#include <string>

namespace mbncc {

/// True for UTF-8 without control characters (C0, DEL, C1), line separators, and direction marks,
/// so that a screen or a log shows exactly the text that is stored.
bool is_printable(const std::string& text);

/// Labels are printable and have at most 200 bytes.
bool is_valid_label(const std::string& label);

}  // namespace mbncc
