// SPDX-License-Identifier: BSD-3-Clause
// "Did you mean ...?" for misspelt keys and flags.
#pragma once

#include <string>
#include <vector>

namespace mbncc {

/// "; did you mean 'KNOWN'?" with the known word of the smallest edit distance to `word`; "" if
/// that distance exceeds one plus a quarter of the length of `word`.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace mbncc
