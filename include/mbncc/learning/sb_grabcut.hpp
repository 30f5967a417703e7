// SPDX-License-Identifier: BSD-3-Clause
// Superpixel-based GrabCut, the paper's segmentation (doi 10.1177/1687814017728839), and the
// traditional GrabCut that the paper compares it with.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <string>

namespace mbncc {

/// Called before each graph cut with its number, counted from 0; may throw to abort.
using BeforeCut = std::function<void(int iteration)>;

/// GrabCut on `image` (CV_8UC3) from a mask of cv::GrabCutClasses of the same size, `iterations`
/// graph cuts. Returns the map (0/255); all 0 if no object pixel remains. Unlike cv::grabCut, it
/// accepts a mask without object or background (and then returns the mask), is deterministic, and
/// does not change the caller's random state.
cv::Mat repeatable_grabcut(const cv::Mat& image, const cv::Mat& mask, int iterations,
                           const BeforeCut& before_cut = {});

/// SB-GrabCut: about `superpixels` superpixels by `method` ("seeds" or "slic"), their mean colours,
/// and GrabCut on that simplified image, initialised with the superpixels that lie mostly inside
/// `approximate` (CV_8UC1, 255 inside). `region` bounds the object. Works on a crop with background
/// on every side of the region. Returns a map of the image's size.
cv::Mat sb_grabcut(const cv::Mat& image, const cv::Rect& region, const cv::Mat& approximate,
                   const std::string& method, int superpixels, int iterations,
                   const BeforeCut& before_cut = {});

/// Traditional GrabCut, initialised with `region` only.
cv::Mat grabcut_rect(const cv::Mat& image, const cv::Rect& region, int iterations,
                     const BeforeCut& before_cut = {});

/// Traditional GrabCut, initialised with the pixels of `approximate` (CV_8UC1, 255 inside).
cv::Mat grabcut_mask(const cv::Mat& image, const cv::Rect& region, const cv::Mat& approximate,
                     int iterations, const BeforeCut& before_cut = {});

/// The region with a surrounding strip of background samples for GrabCut.
cv::Rect grabcut_crop(const cv::Rect& region, const cv::Size& image);

}  // namespace mbncc
