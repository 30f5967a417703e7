// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/unconfirmed_hole.hpp"

#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"
#include "learning/segmentation/clean_map.hpp"

namespace mbncc::segmentation {
namespace {

constexpr int kRim = 7;               // [px] side of the ellipse that removes a hole's blurred rim
constexpr int kFewestPixels = 30;     // of a hole without its rim; fewer show nothing
constexpr double kSameLight = 0.04;   // largest relative difference of a mean colour
constexpr double kTextureScale = 4;   // [px] standard deviation of the smoothing
constexpr double kSameTexture = 0.4;  // least correlation of the texture

// Differences of `image` from its smoothed copy; both only of the pixels of `weight` (CV_32FC1).
cv::Mat texture(const cv::Mat& image, const cv::Mat& weight) {
  cv::Mat weights, total, smooth, norm;
  cv::merge(std::vector<cv::Mat>(3, weight), weights);
  cv::GaussianBlur(image.mul(weights), total, cv::Size(), kTextureScale);
  cv::GaussianBlur(weights, norm, cv::Size(), kTextureScale);
  cv::divide(total, cv::max(norm, 1e-6), smooth);
  return (image - smooth).mul(weights);
}

bool same_texture(const cv::Mat& before, const cv::Mat& after, const cv::Mat& hole) {
  cv::Mat weight;
  hole.convertTo(weight, CV_32F, 1 / 255.0);
  const cv::Mat a = texture(before, weight), b = texture(after, weight);
  return a.dot(b) > kSameTexture * std::sqrt(a.dot(a) * b.dot(b));
}

bool same_light(const cv::Mat& before, const cv::Mat& after, const cv::Mat& hole) {
  const cv::Scalar a = cv::mean(before, hole), b = cv::mean(after, hole);
  for (int channel = 0; channel < 3; ++channel)
    if (std::abs(a[channel] - b[channel]) > kSameLight * b[channel]) return false;
  return true;
}

// Without the blurred rim.
cv::Mat inner_pixels(const cv::Mat& hole) {
  cv::Mat inner;
  cv::erode(hole, inner, cv::getStructuringElement(cv::MORPH_ELLIPSE, {kRim, kRim}), {-1, -1}, 1,
            cv::BORDER_CONSTANT, cv::Scalar(0));
  return inner;
}

// Part of the map with the counted holes filled. `counts` gets the box and the mask of a hole.
double part_of_holes(const cv::Mat& map,
                     const std::function<bool(const cv::Rect&, const cv::Mat&)>& counts) {
  cv::Mat filled = map.clone(), labels, stats, centres;
  fill_holes(filled, static_cast<int>(map.total()));
  const int count =
      cv::connectedComponentsWithStats(filled & ~map, labels, stats, centres, 4, CV_32S);
  double area = 0;
  for (int label = 1; label < count; ++label) {
    const cv::Rect box = imaging::box_of_component(stats, label);
    if (counts(box, labels(box) == label)) area += stats.at<int>(label, cv::CC_STAT_AREA);
  }
  return area == 0 ? 0 : area / (area + cv::countNonZero(map));
}

bool touches(const cv::Mat& excluded, const cv::Rect& box, const cv::Mat& inner) {
  return !excluded.empty() && cv::countNonZero(inner & excluded(box)) > 0;
}

}  // namespace

double unconfirmed_hole(const cv::Mat& map, const cv::Mat& before, const cv::Mat& after,
                        const cv::Mat& excluded) {
  return part_of_holes(map, [&](const cv::Rect& box, const cv::Mat& hole) {
    const cv::Mat inner = inner_pixels(hole);
    return cv::countNonZero(inner) >= kFewestPixels && !touches(excluded, box, inner) &&
           !same_light(before(box), after(box), inner) &&
           !same_texture(before(box), after(box), inner);
  });
}

double enclosed_part(const cv::Mat& map, const cv::Mat& excluded) {
  return part_of_holes(map, [&](const cv::Rect& box, const cv::Mat& hole) {
    return !touches(excluded, box, inner_pixels(hole));
  });
}

}  // namespace mbncc::segmentation
