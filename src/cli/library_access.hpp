// SPDX-License-Identifier: BSD-3-Clause
// Gives the commands access to the library.
#pragma once

#include <memory>

#include "cli/arguments.hpp"
#include "mbncc/library/object_library.hpp"

namespace mbncc::cli {

/// The folder given by --library, or else the one that the nodelets use.
std::string library_folder(const Arguments& arguments);

/// Opens library_folder() if it exists; throws FileError otherwise, so that a misspelt path does
/// not create a new library.
ObjectLibrary existing_library(const Arguments& arguments);

/// The library's content; files that cannot be read or are not objects are reported on stderr.
std::shared_ptr<const LibrarySnapshot> load_reporting(ObjectLibrary& library);

/// Like load_reporting(), but throws std::runtime_error if there are no objects.
std::shared_ptr<const LibrarySnapshot> load_objects(ObjectLibrary& library);

/// The object given by --name. Throws std::invalid_argument that lists the known names.
std::shared_ptr<const ObjectModel> named_object(const LibrarySnapshot& snapshot,
                                                const std::string& name);

}  // namespace mbncc::cli
