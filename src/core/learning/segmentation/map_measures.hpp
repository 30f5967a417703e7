// SPDX-License-Identifier: BSD-3-Clause
// Measures of a map and its template without a search.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "mbncc/object_model.hpp"

namespace mbncc::segmentation {

/// Part [px] of the learning image that the measures need. A map pixel on the border of this part
/// is also on the image's border.
cv::Rect surroundings(const View& view);

/// Fills in area, fill, contrast and edge_agreement. `map` has the image's size.
void measure_map(const cv::Mat& image, const cv::Mat& map, Quality& quality);

/// Part [0..1] of the outline with an edge of `image` (CV_8UC3) within a pixel; 0 if the map is
/// empty.
double edge_agreement(const cv::Mat& image, const cv::Mat& map);

/// Part [0..1] of the outline with an edge of `after` within a pixel that `before` hardly has; 0 if
/// the map is empty. All have one size, and the images are CV_8UC3. What left has its edges before.
double edges_only_after(const cv::Mat& before, const cv::Mat& after, const cv::Mat& map);

/// IoU [0..1] of two maps of one size (CV_8UC1); 0 if both are empty.
double map_iou(const cv::Mat& a, const cv::Mat& b);

/// Largest IoU of the map with a map of `object`, moved to the pose `found` [px] of the object
/// frame.
double agreement_at(const ObjectModel& object, const Pose2D& found, const cv::Mat& map);

/// IoU of the map with the changed pixels around it (CV_8UC1).
double change_agreement(const cv::Mat& changed, const cv::Mat& map);

/// Whether a map pixel lies on the image's border.
bool touches_border(const cv::Mat& map);

/// Outermost map pixels.
cv::Mat outline_pixels(const cv::Mat& map);

}  // namespace mbncc::segmentation
