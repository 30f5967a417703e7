// SPDX-License-Identifier: BSD-3-Clause
// One object as one file: an 8-bit RGBA PNG (colour: the image around the object, alpha: the map,
// views stacked from top to bottom) with one text chunk "mbncc" that holds YAML. Any image viewer
// shows it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc {

/// Format that this version writes; newer ones are refused with a message and left unchanged.
constexpr int kObjectFileVersion = 1;

/// Suffix of an object's file name, in the library and its trash.
constexpr const char* kObjectFileEnding = ".png";

/// Bytes of the file. Throws std::invalid_argument if the model violates the rules of
/// object_model.hpp.
std::vector<std::uint8_t> encode_object(const ObjectModel& model);

/// Decodes the bytes of a file; errors name `path`. Checks sizes before it allocates memory, and
/// all CRCs. Throws FileError.
ObjectModel decode_object(const std::vector<std::uint8_t>& bytes, const std::string& path);

/// Whether the path is a regular file with the description of an object, which must not be replaced
/// except by the library.
bool is_object_file(const std::string& path);

/// Reads a regular file of bounded size (no FIFO, no directory, no symbolic link). Throws
/// FileError.
ObjectModel read_object_file(const std::string& path);

}  // namespace mbncc
