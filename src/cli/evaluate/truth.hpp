// SPDX-License-Identifier: BSD-3-Clause
// The true poses in the images of an evaluation.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::cli {

struct TrueInstance {
  std::string name;  ///< "": the file does not name the object
  Pose2D pose;       ///< [px],[rad] of the object frame
};

/// True instances by path, as listed. An image that is not listed contains no object.
using Truth = std::map<std::string, std::vector<TrueInstance>>;

/// The entry of an image: the listed path that its absolute path ends with, the longest of several;
/// the end of `truth` if there is none.
Truth::const_iterator entry_of(const Truth& truth, const std::string& image_path);

/// Reads a CSV file with a header: image, x, y [px], theta_deg, and name if the library has several
/// objects; a row with an empty x is an image without objects. Throws FileError that names the line
/// or the unknown column.
Truth read_truth(const std::string& path);

}  // namespace mbncc::cli
