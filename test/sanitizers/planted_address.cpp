// SPDX-License-Identifier: BSD-3-Clause
// Leaks memory; writes beyond an array when given an argument. scripts/sanitize runs both.
#include <cstdlib>

int main(int argc, char**) {
  char* volatile bytes = static_cast<char*>(std::malloc(4));
  if (argc > 1) bytes[argc + 2] = 1;
  bytes = nullptr;
  return 0;
}
