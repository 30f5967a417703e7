// SPDX-License-Identifier: BSD-3-Clause
// Two threads write to one number.
#include <thread>

int main() {
  int number = 0;
  std::thread other([&number] { ++number; });
  ++number;
  other.join();
  return number == 2 ? 0 : 1;
}
