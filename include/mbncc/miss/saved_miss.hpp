// SPDX-License-Identifier: BSD-3-Clause
// One file with all that a search's miss depends on: picture, library, settings and place, so that
// it can be run again elsewhere. YAML with pictures and objects as base64; the first lines are for
// people.
#pragma once

#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/config/search_config.hpp"
#include "mbncc/matching/explanation.hpp"
#include "mbncc/object_model.hpp"

namespace mbncc {

/// Format written by this version; newer ones are refused with a sentence.
constexpr int kMissFileVersion = 1;

struct SavedMiss {
  cv::Mat picture;                 ///< CV_8UC3, at most 8 million pixels
  cv::Point2d place;               ///< [px] that was asked about
  std::vector<std::string> names;  ///< asked about; empty: all enabled
  SearchConfig search;
  std::vector<std::shared_ptr<const ObjectModel>> objects;
  std::vector<std::string> lines;  ///< the explanation when it was saved
};

/// Explains the place again, by this version.
std::vector<Explanation> explain(const SavedMiss& miss);

/// Lines of the likeliest explanations, `most` of them.
std::vector<std::string> lines_of(const std::vector<Explanation>& explanations, std::size_t most);

/// Throws FileError, and std::invalid_argument for what fits into no file.
void write_miss(const std::string& path, const SavedMiss& miss);

/// Throws FileError.
SavedMiss read_miss(const std::string& path);

}  // namespace mbncc
