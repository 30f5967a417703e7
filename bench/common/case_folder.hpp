// SPDX-License-Identifier: BSD-3-Clause
// A case of an evaluation set: one object's learning images with its true map, and images to
// search with the true poses (see bench/README.md for the files).
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/geometry.hpp"

namespace mbncc::bench {

/// Where the object lies in a target.
struct Instance {
  Pose2D pose;       ///< [px],[rad] of the reference point; rotation against the learning image
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
  cv::Mat before;         ///< CV_8UC3, the object lies there
  cv::Mat after;          ///< CV_8UC3, the object is gone; empty where the set has none
  cv::Rect region;        ///< [px] the operator's rough rectangle; empty where the set has none
  cv::Mat map;            ///< CV_8UC1 true map, 0 and 255
  cv::Point2d reference;  ///< [px] in `before`
  double diameter = 0;    ///< [px] of the true map's excircle
  std::vector<std::string> tags;
  std::vector<Target> targets;
};

/// Names of the cases in a set, sorted, the first `most` (0: all). Throws std::runtime_error when
/// there are none.
std::vector<std::string> list_cases(const std::filesystem::path& set, std::size_t most = 0);

/// Throws std::runtime_error naming the file that is missing or wrong.
CaseFolder read_case(const std::filesystem::path& folder);

/// Symmetry of an object tagged "sym:<period in degrees, 0 = any angle>".
int symmetry_of(const std::vector<std::string>& tags);

/// CV_8UC3; throws std::runtime_error when the file is no image.
cv::Mat read_image(const std::filesystem::path& path);

}  // namespace mbncc::bench
