// SPDX-License-Identifier: BSD-3-Clause
// Texts that people are shown: what they call an object beside its name, and names of frames.
#pragma once

#include <string>

namespace mbncc {

/// UTF-8 without control characters (C0, DEL, C1), line separators, and what changes the direction
/// of text: nothing that could make a screen or a log show another text than it holds.
bool is_printable(const std::string& text);

/// Labels are printable and have at most 200 bytes.
bool is_valid_label(const std::string& label);

}  // namespace mbncc
