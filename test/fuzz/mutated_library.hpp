// SPDX-License-Identifier: BSD-3-Clause
// Libraries of objects that were changed in some way: fields, sizes, shapes, aliases, names, bytes.
#pragma once

#include <string>

namespace mbncc::fuzz {

/// One object of every such library is sound.
constexpr const char* kSound = "victim";

/// [px] of the image that it is learned in.
constexpr int kImageWidth = 80, kImageHeight = 60;

/// Fills the empty folder with the sound object and one or two mutated files or folders, all by the
/// seed.
void make_mutated_library(const std::string& folder, unsigned seed);

/// Adds one or two more mutated ones.
void make_mutants(const std::string& folder, unsigned seed);

}  // namespace mbncc::fuzz
