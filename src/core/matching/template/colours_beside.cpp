// SPDX-License-Identifier: BSD-3-Clause
#include "matching/template/colours_beside.hpp"

#include <array>
#include <vector>

#include "numeric/order_statistics.hpp"

namespace mbncc::templates {

std::optional<cv::Vec3f> colour_beside(const templates::ContourTemplate& contour, std::size_t k,
                                       double distance, const cv::Mat& colours, const Pose2D& pose,
                                       double scale) {
  const cv::Point at = transform(pose, {scale * contour.x[k] + distance * contour.normal_x[k],
                                        scale * contour.y[k] + distance * contour.normal_y[k]});
  if (!at.inside(cv::Rect({0, 0}, colours.size()))) return std::nullopt;
  return cv::Vec3f(colours.at<cv::Vec3b>(at));
}

cv::Vec3f background_colour(const templates::ContourTemplate& contour,
                            const scene::SceneLevel& scene, const Pose2D& pose, double scale) {
  const scene::PreparedPixels pixels = scene.around(pose, scale * contour.radius());
  std::array<std::vector<float>, 3> colours;
  for (std::size_t k = 0; k < contour.size(); ++k)
    if (const auto colour = colour_beside(contour, k, kBeside, pixels.colour, pose, scale))
      for (int c = 0; c < 3; ++c) colours[c].push_back((*colour)[c]);
  return {numeric::median(colours[0]), numeric::median(colours[1]), numeric::median(colours[2])};
}

}  // namespace mbncc::templates
