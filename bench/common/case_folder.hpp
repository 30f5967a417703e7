// SPDX-License-Identifier: BSD-3-Clause
// A case of an evaluation set: the learning images of one object with its true map, and images to
// search with the true poses (bench/README.md describes the files).
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::bench {

/// Pose of the object in a target.
struct Instance {
  Pose2D pose;       ///< [px],[rad] of the reference point; rotation relative to the learning image
  int symmetry = 1;  ///< 1: none, 2: 180 degrees ..., 0: round
  std::vector<std::string> tags;
};

/// One image to search.
struct Target {
  std::string name;
  std::filesystem::path image;
  std::vector<Instance> instances;  ///< empty: the object is absent
  std::vector<std::string> tags;
};

struct CaseFolder {
  std::string name;
  std::filesystem::path folder;
  cv::Mat before;         ///< CV_8UC3, with the object
  cv::Mat after;          ///< CV_8UC3, without the object; empty if the set has none
  cv::Rect region;        ///< [px] the operator's rough rectangle; empty if the set has none
  cv::Mat map;            ///< CV_8UC1 true map, 0 and 255
  cv::Point2d reference;  ///< [px] in `before`
  double diameter = 0;    ///< [px] of the true map's excircle
  std::vector<std::string> tags;
  std::vector<Target> targets;
};

/// Sorted names of the cases in a set; with `most` > 0, only the first `most`. Throws
/// std::runtime_error if there are none.
std::vector<std::string> list_cases(const std::filesystem::path& set, std::size_t most = 0);

/// Throws std::runtime_error that names the missing or invalid file.
CaseFolder read_case(const std::filesystem::path& folder);

/// Symmetry of an object tagged "sym:<period in degrees, 0 = any angle>".
int symmetry_of(const std::vector<std::string>& tags);

/// CV_8UC3 image; throws std::runtime_error if the file is not an image.
cv::Mat read_image(const std::filesystem::path& path);

}  // namespace mbncc::bench
