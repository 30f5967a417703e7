// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes images.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace mbncc::cli {

/// CV_8UC3 image from a PNG or JPEG file with at most 8 bits per channel; grey becomes colour,
/// transparency is dropped. Rows and columns are those of the sensor: an EXIF orientation is not
/// applied but reported on stderr. Throws FileError with a remedy.
cv::Mat read_image(const std::string& path);

/// CV_8UC1 map with values 0 and 255, thresholded at half of the range. Throws FileError, also for
/// a photograph, because a map has only two grey values.
cv::Mat read_map(const std::string& path);

/// Refuses to write over an object, which only the library replaces, or over one of the `inputs`:
/// throws FileError.
void refuse_to_replace(const std::string& path, const std::vector<std::string>& inputs);

/// Writes a PNG file. Throws FileError, also if refuse_to_replace() does.
void write_image(const std::string& path, const cv::Mat& image,
                 const std::vector<std::string>& inputs);

/// Creates the folder and its parents if they are missing. Throws FileError.
void make_output_folder(const std::string& folder);

}  // namespace mbncc::cli
