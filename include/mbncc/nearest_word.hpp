// "Did you mean ...?" for misspelt keys and flags.
#pragma once

#include <string>
#include <vector>

namespace mbncc {

/// The known word with the fewest edits from `word`; "" when none is known.
std::string nearest_word(const std::string& word, const std::vector<std::string>& known);

}  // namespace mbncc
