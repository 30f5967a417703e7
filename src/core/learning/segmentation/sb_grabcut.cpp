// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/sb_grabcut.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "mbncc/learning/superpixels.hpp"
#include "numeric/fixed_random_state.hpp"

namespace mbncc {
namespace {

cv::Mat foreground_of(const cv::Mat& classes) {
  return (classes == cv::GC_FGD) | (classes == cv::GC_PR_FGD);
}

// cv::grabCut asserts if one side's mixture has no sample.
bool has_both_sides(const cv::Mat& classes) {
  const int foreground = cv::countNonZero(foreground_of(classes));
  return foreground > 0 && foreground < static_cast<int>(classes.total());
}

// Inside the approximate region: probably object; elsewhere in the region: probably not; beyond it:
// certainly not.
cv::Mat initial_classes(const cv::Mat& probable, const cv::Rect& region) {
  cv::Mat classes(probable.size(), CV_8UC1, cv::Scalar(cv::GC_BGD));
  classes(region).setTo(cv::GC_PR_BGD);
  classes(region).setTo(cv::GC_PR_FGD, probable(region));
  return classes;
}

cv::Mat at_full_size(const cv::Mat& crop_map, const cv::Rect& crop, const cv::Size& size) {
  cv::Mat full = cv::Mat::zeros(size, CV_8UC1);
  crop_map.copyTo(full(crop));
  return full;
}

}  // namespace

cv::Rect grabcut_crop(const cv::Rect& region, const cv::Size& image) {
  const int margin = std::max(10, std::max(region.width, region.height) / 4);
  const cv::Rect grown(region.x - margin, region.y - margin, region.width + 2 * margin,
                       region.height + 2 * margin);
  return grown & cv::Rect({0, 0}, image);
}

cv::Mat repeatable_grabcut(const cv::Mat& image, const cv::Mat& mask, int iterations,
                           const BeforeCut& before_cut) {
  const numeric::FixedRandomState fixed;
  cv::Mat classes = mask.clone(), background, foreground;
  for (int i = 0; i < iterations; ++i) {
    if (before_cut) before_cut(i);
    if (!has_both_sides(classes)) break;
    cv::grabCut(image, classes, {}, background, foreground, 1,
                i == 0 ? cv::GC_INIT_WITH_MASK : cv::GC_EVAL);
  }
  return foreground_of(classes);
}

cv::Mat sb_grabcut(const cv::Mat& image, const cv::Rect& region, const cv::Mat& approximate,
                   const std::string& method, int superpixels, int iterations,
                   const BeforeCut& before_cut) {
  const cv::Rect crop = grabcut_crop(region, image.size());
  const Superpixels cells = superpixels_of(image(crop), method, superpixels);
  const cv::Mat probable = superpixels_inside(cells, approximate(crop));
  const cv::Mat simplified = simplify_superpixels(image(crop), cells);
  const cv::Mat classes = initial_classes(probable, region - crop.tl());
  return at_full_size(repeatable_grabcut(simplified, classes, iterations, before_cut), crop,
                      image.size());
}

cv::Mat grabcut_rect(const cv::Mat& image, const cv::Rect& region, int iterations,
                     const BeforeCut& before_cut) {
  cv::Mat whole_region = cv::Mat::zeros(image.size(), CV_8UC1);
  whole_region(region).setTo(255);
  return grabcut_mask(image, region, whole_region, iterations, before_cut);
}

cv::Mat grabcut_mask(const cv::Mat& image, const cv::Rect& region, const cv::Mat& approximate,
                     int iterations, const BeforeCut& before_cut) {
  const cv::Rect crop = grabcut_crop(region, image.size());
  const cv::Mat classes = initial_classes(approximate(crop), region - crop.tl());
  return at_full_size(repeatable_grabcut(image(crop), classes, iterations, before_cut), crop,
                      image.size());
}

}  // namespace mbncc
