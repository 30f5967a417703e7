// SPDX-License-Identifier: BSD-3-Clause
// Access of the commands to the library.
#pragma once

#include <memory>

#include "cli/arguments.hpp"
#include "mbncc/library/object_library.hpp"

namespace mbncc::cli {

/// The folder given by --library, else the nodelets' own.
std::string library_folder(const Arguments& arguments);

/// library_folder() if it exists; throws FileError otherwise, so that a misspelt path does not
/// create a new library.
ObjectLibrary existing_library(const Arguments& arguments);

/// Its content; files that cannot be read or are no objects are reported on stderr.
std::shared_ptr<const LibrarySnapshot> load_reporting(ObjectLibrary& library);

/// The same of a library with objects; throws std::runtime_error if there are none.
std::shared_ptr<const LibrarySnapshot> load_objects(ObjectLibrary& library);

/// The object given by --name. Throws std::invalid_argument listing the known names.
std::shared_ptr<const ObjectModel> named_object(const LibrarySnapshot& snapshot,
                                                const std::string& name);

}  // namespace mbncc::cli
