// SPDX-License-Identifier: BSD-3-Clause
// A file with the complete input of a failed search: image, library, settings and place, so that
// the search can be repeated elsewhere. YAML with images and objects as base64; the first lines are
// a readable summary.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/explanation.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Format that this version writes; newer ones are refused with a message.
constexpr int kMissFileVersion = 1;

/// Number of explanations that are told, the likeliest first.
constexpr std::size_t kExplained = 3;

struct SavedMiss {
  cv::Mat image;                   ///< CV_8UC3, at most 8 million pixels
  cv::Point2d place;               ///< [px] the place to explain
  std::vector<std::string> names;  ///< objects to explain; empty: all enabled
  SearchConfig search;
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  std::vector<std::string> lines;  ///< the explanation at the time of saving
};

/// Computes the explanation again with this version of the package.
std::vector<Explanation> explain(const SavedMiss& miss);

/// Lines of the `most` likeliest explanations.
std::vector<std::string> lines_of(const std::vector<Explanation>& explanations, std::size_t most);

/// Throws FileError, and std::invalid_argument if the miss does not fit into a file.
void write_miss(const std::string& path, const SavedMiss& miss);

/// Throws FileError.
SavedMiss read_miss(const std::string& path);

}  // namespace mbncc
