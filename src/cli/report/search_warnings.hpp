// SPDX-License-Identifier: BSD-3-Clause
// Warnings on stderr about objects that an image may show but a search does not find.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "mbncc/library/library_snapshot.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::cli {

/// Names the objects that were not searched for, with the reasons.
void warn_of_skipped(const std::string& image_path, const SearchResult& result);

/// Names an enabled object that was learned in images of another size, of those in `names`; empty:
/// of all. The tool searches for it anyway, because the image may be a crop.
void warn_of_other_size(const std::string& image_path, cv::Size size,
                        const LibrarySnapshot& library, const std::vector<std::string>& names);

}  // namespace mbncc::cli
