// What people call an object, beside its name.
#pragma once

#include <string>

namespace mbncc {

/// Labels are printable UTF-8 of at most 200 bytes.
bool is_valid_label(const std::string& label);

}  // namespace mbncc
