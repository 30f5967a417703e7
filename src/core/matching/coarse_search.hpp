// Correlation of all rotations at all positions of one pyramid level.
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "matching/candidate.hpp"
#include "matching/places.hpp"
#include "matching/rotated_kernels.hpp"
#include "matching/rotation_sector.hpp"

namespace mbncc {

struct CoarseSettings {
  double min_similarity = 0.3;   ///< [-1..1] of a candidate
  int max_places = 100;          ///< best places kept
  double rotation_slack = 0.12;  ///< further rotations at a place are kept when they come this near
};

/// Local maxima over positions in `roi` [px at the bank's level] and `places` and over rotations in
/// `sector`.
/// `grey` is the pyramid's level of the bank, CV_8UC1; beyond its border it is continued by its
/// edge values.
std::vector<Candidate> coarse_search(const KernelBank& bank, const cv::Mat& grey,
                                     const cv::Rect& roi, const CoarseSettings& settings = {},
                                     const RotationSector& sector = {}, const Places& places = {});

/// CV_32FC1 of grey's size: the largest similarity over all rotations at each position; where it is
/// below 0 it is not worked out.
cv::Mat coarse_similarity(const KernelBank& bank, const cv::Mat& grey);

}  // namespace mbncc
