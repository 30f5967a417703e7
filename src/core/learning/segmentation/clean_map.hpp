// SPDX-License-Identifier: BSD-3-Clause
// Cleans a raw cut to the map of one object.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::segmentation {

/// Removes the groups of pieces (pieces nearer than `gap` pixels form a group) that have less than
/// a quarter of the largest weight and contain no `wanted` pixel. `weight` is CV_32FC1 (negative
/// counts as 0); empty: each pixel 1.
void keep_main_groups(cv::Mat& map, const cv::Mat& weight, const cv::Mat& wanted = {}, int gap = 3);

/// Removes connected pieces of fewer than `area` pixels.
void remove_specks(cv::Mat& map, int area);

/// Fills enclosed holes of at most `area` pixels.
void fill_holes(cv::Mat& map, int area);

/// Main groups with holes filled, and a 3 x 3 median against ragged outlines. Holes go up to .2 %
/// of the map.
cv::Mat clean_map(const cv::Mat& raw, const cv::Mat& weight = {}, const cv::Mat& wanted = {});

}  // namespace mbncc::segmentation
