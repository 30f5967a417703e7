// SPDX-License-Identifier: BSD-3-Clause
// Libraries with mutated objects: fields, sizes, shapes, aliases, names, bytes.
#pragma once

#include <string>

namespace mbncc::fuzz {

/// Name of the one object that is valid in every such library.
constexpr const char* kSound = "victim";

/// [px] size of the image in which it is learned.
constexpr int kImageWidth = 80, kImageHeight = 60;

/// Fills the empty folder with the valid object and one or two mutated files or folders; the seed
/// determines all of them.
void make_mutated_library(const std::string& folder, unsigned seed);

/// Adds one or two more mutated files or folders.
void make_mutants(const std::string& folder, unsigned seed);

}  // namespace mbncc::fuzz
