// SPDX-License-Identifier: BSD-3-Clause
// Colours beside the contour of an object at a pose.
#pragma once

#include <opencv2/core.hpp>
#include <optional>

#include "matching/scene/scene_level.hpp"
#include "matching/template/contour_template.hpp"

namespace mbncc::templates {

constexpr double kBeside = 4;  // [px] distance from the contour at which colours are read

/// Colour (b, g, r) `distance` [px] outside (inside if negative) point `k` of the contour, `scale`
/// times as large, at `pose`; none outside the image. `colours` is CV_8UC3.
std::optional<cv::Vec3f> colour_beside(const templates::ContourTemplate& contour, std::size_t k,
                                       double distance, const cv::Mat& colours, const Pose2D& pose,
                                       double scale);

/// Median colour (b, g, r) kBeside outside the contour.
cv::Vec3f background_colour(const templates::ContourTemplate& contour,
                            const scene::SceneLevel& scene, const Pose2D& pose, double scale = 1);

}  // namespace mbncc::templates
