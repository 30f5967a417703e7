// SPDX-License-Identifier: BSD-3-Clause
// Reduces a raw cut to the map of one object.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::segmentation {

/// Removes the groups of pieces (pieces nearer than `gap` pixels form a group) that have less than
/// 18 % of the largest weight and contain no `wanted` pixel. `weight` is CV_32FC1 (negative counts
/// as 0); empty: each pixel 1.
void keep_main_groups(cv::Mat& map, const cv::Mat& weight, const cv::Mat& wanted = {}, int gap = 3);

/// Removes connected pieces of fewer than `area` pixels.
void remove_specks(cv::Mat& map, int area);

/// Fills enclosed holes of at most `area` pixels.
void fill_holes(cv::Mat& map, int area);

/// Keeps the main groups, fills holes of up to 0.2 % of the map (at least 12 px), and smooths the
/// outline by a 3 x 3 median.
cv::Mat clean_map(const cv::Mat& raw, const cv::Mat& weight = {}, const cv::Mat& wanted = {});

}  // namespace mbncc::segmentation
