// SPDX-License-Identifier: BSD-3-Clause
// Estimates an approximate region from one point on the object.
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace mbncc::teaching {

/// Squares [px] with their centre at `click`, the first `largest` wide, each .8 times as wide as
/// the one before, down to 20 pixels; clipped to `room`. A square is left out if less than 10
/// pixels of its width or height remain.
std::vector<cv::Rect> squares_about(const cv::Point2d& click, double largest, const cv::Rect& room);

struct ClickedRegion {
  cv::Rect square;       ///< [px] clipped to the image
  cv::Mat map;           ///< CV_8UC1 of the image's size, 255 on the object
  double agreement = 0;  ///< [0..1] squares that gave a map of this size, as a part of six
};

/// The object at `click` in one image (CV_8UC3): region_cut() in squares about it, and
/// the map that most squares agree on and whose outline lies on clear edges; the idea of
/// maximally stable extremal regions (Matas et al. 2002). None if no square has a map there.
std::optional<ClickedRegion> stable_region(const cv::Mat& image, const cv::Point2d& click,
                                           int iterations);

/// 255 on the connected piece of `mask` (CV_8UC1) at the click, or else on the nearest one within
/// 15 pixels, or else on the one that encloses it; all 0 if there is none.
cv::Mat piece_at(const cv::Mat& mask, const cv::Point2d& click);

/// 255 on the connected pieces of `mask` with a pixel of `seed`; both CV_8UC1 of one size.
cv::Mat pieces_with(const cv::Mat& mask, const cv::Mat& seed);

/// 255 on the enclosed hole of `mask` (CV_8UC1) that contains the click, which lies in the image;
/// all 0 if there is none, or `mask` has pixels within 15 pixels, because clicks may miss by that.
cv::Mat hole_at(const cv::Mat& mask, const cv::Point2d& click);

/// piece_at() of `changed` (CV_8UC1), with pieces less than 9 pixels apart joined.
cv::Mat change_at_click(const cv::Mat& changed, const cv::Point2d& click);

/// Throws LessonEnded(kSegmentationEmpty): nothing was cut out at the click.
[[noreturn]] void refuse_click();

}  // namespace mbncc::teaching
