// SPDX-License-Identifier: BSD-3-Clause
// Correlation of all rotations at all positions of one pyramid level.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "imaging/padded_image.hpp"
#include "matching/proposal/template_bank.hpp"
#include "matching/template/candidate.hpp"

namespace mbncc::proposal {

/// Local maxima of the similarity over positions in `roi` [px at the bank's level] and
/// all rotations. `image` is the bank's level, with a margin of more than the bank's radius; `roi`
/// lies in it.
std::vector<templates::Candidate> coarse_search(const TemplateBank& bank,
                                                const imaging::PaddedImage& image,
                                                const cv::Rect& roi, std::size_t most);

/// CV_32FC1 of `size`, that of the level: the largest similarity over all rotations at each
/// position; negative values are not computed. `image`: see coarse_search().
cv::Mat coarse_similarity(const TemplateBank& bank, const imaging::PaddedImage& image,
                          cv::Size size);

}  // namespace mbncc::proposal
