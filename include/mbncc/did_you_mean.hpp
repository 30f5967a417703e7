// SPDX-License-Identifier: BSD-3-Clause
// "Did you mean ...?" for misspelt keys and flags.
#pragma once

#include <string>
#include <vector>

namespace mbncc {

/// "; did you mean 'KNOWN'?" of the known word with the fewest edits (letters put in, left out or
/// exchanged) from `word`; "" when even that one differs by more than one edit and another for
/// every four letters of `word`.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace mbncc
