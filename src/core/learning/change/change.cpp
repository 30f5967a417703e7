// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/change.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/change/camera_shift.hpp"
#include "learning/change/exposure.hpp"
#include "learning/change/phase_shift.hpp"
#include "learning/change/rectangles.hpp"
#include "learning/change/statistics.hpp"
#include "learning/change/strips.hpp"
#include "learning/change/survey_size.hpp"
#include "learning/change/texture_change.hpp"

namespace mbncc {
namespace {

constexpr float kLeastDifference = 18;  // [grey levels, summed over channels] above usual noise
constexpr float kNoiseFactor = 5;       // factor of a change to the median difference
constexpr float kSureDifference = 45;   // [likewise] a change in any case
constexpr double kMargin = 0.15;        // of a changed region's longer side
constexpr double kNoisyMargin = 0.6;    // likewise, where noise hides part of the change
constexpr double kClearGain = 0.8;      // a shift must lower the difference to this part
constexpr int kGap = 9;                 // [px] pieces nearer than this are joined
constexpr int kSampling = 2;            // [px] of the survey, for medians
constexpr double kBlackLevel = 10;      // [grey levels] possible black level of cameras

// CV_32FC1 of a CV_8UC3 image times `gain` per channel.
cv::Mat grey_of(const cv::Mat& image, const cv::Scalar& gain) {
  cv::Mat grey(image.size(), CV_32FC1), strip;
  change::for_each_strip(image.rows, [&](const cv::Range& rows) {
    cv::multiply(image.rowRange(rows), gain, strip, 1, CV_32F);
    cv::Mat part = grey.rowRange(rows);
    cv::cvtColor(strip, part, cv::COLOR_BGR2GRAY);
  });
  return grey;
}

// Mean difference of two grey images; large ones count no more than kLeastDifference.
double mean_difference(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat difference;
  cv::absdiff(before, after, difference);
  return cv::mean(cv::min(difference, kLeastDifference))[0];
}

// By phase correlation, used only if it explains the images.
cv::Point2d coarse_shift(const cv::Mat& before, const cv::Mat& after) {
  const cv::Point2d shift = change::phase_shift(before, after);
  const cv::Rect inner(before.cols / 4, before.rows / 4, before.cols / 2, before.rows / 2);
  const cv::Mat moved = change::undo_shift(after, shift);
  const bool explains = mean_difference(before(inner), moved(inner)) <
                        kClearGain * mean_difference(before(inner), after(inner));
  return explains ? shift : cv::Point2d();
}

// Difference of the images, the one after times `gain`, summed over channels, averaged over
// 3 x 3.
cv::Mat difference_of(const cv::Mat& before, const cv::Mat& after, const cv::Scalar& gain) {
  cv::Mat difference(before.size(), CV_32FC1), b, a;
  change::for_each_strip(before.rows, [&](const cv::Range& rows) {
    before.rowRange(rows).convertTo(b, CV_32F);
    cv::multiply(after.rowRange(rows), gain, a, 1, CV_32F);
    cv::absdiff(b, a, a);
    cv::Mat part = difference.rowRange(rows);
    cv::transform(a, part, cv::Matx13f(1, 1, 1));
  });
  cv::blur(difference, difference, {3, 3});
  return difference;
}

// Threshold of a changed pixel, from the median difference.
float change_threshold(const cv::Mat& difference) {
  std::vector<float> values;
  for (int y = 0; y < difference.rows; y += kSampling)
    for (int x = 0; x < difference.cols; x += kSampling)
      values.push_back(difference.at<float>(y, x));
  return std::clamp(kNoiseFactor * change::median(values), kLeastDifference, kSureDifference);
}

struct Patch {
  cv::Rect box;
  int area = 0;       // [px]
  double weight = 0;  // sum over its pixels
};

// Groups of changed pixels, with nearby pieces joined. `labels` contains the result's index plus
// one.
std::vector<Patch> joined_patches(const cv::Mat& changed, cv::Mat& labels) {
  cv::Mat joined, stats, centres;
  cv::morphologyEx(changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
  std::vector<Patch> patches;
  for (int i = 1; i < count; ++i)
    patches.push_back({change::box_of_component(stats, i), stats.at<int>(i, cv::CC_STAT_AREA)});
  return patches;
}

// Factor >= 1 between images that have the mean `brightness` after compensation. In dark images
// a black level looks like exposure, but does not change the contrast.
double exposure_change(double gain, double contrast, double brightness) {
  const auto factor = [](double ratio) { return std::max(ratio, 1 / std::max(ratio, 1e-3)); };
  const bool is_black_level = std::abs(1 - contrast) * brightness < kBlackLevel;
  return is_black_level ? std::min(factor(gain), factor(gain * contrast)) : factor(gain);
}

cv::Rect with_margin(const cv::Rect& box, bool noisy) {
  const double part = noisy ? kNoisyMargin : kMargin;
  return change::grown(box, std::max(8, static_cast<int>(part * std::max(box.width, box.height))));
}

}  // namespace

ChangeSurvey survey_change(const cv::Mat& before, const cv::Mat& after) {
  const cv::Mat b = change::survey_sized(before);
  cv::Mat a = change::survey_sized(after);
  ChangeSurvey survey;
  const change::Exposure exposure = change::exposure_of(b, a);
  survey.unevenness = exposure.unevenness;
  cv::Scalar light(exposure.gain[0], exposure.gain[1], exposure.gain[2]);
  const cv::Mat grey_before = grey_of(b, cv::Scalar::all(1));
  cv::Mat grey_after = grey_of(a, light);
  const cv::Point2d shift = coarse_shift(grey_before, grey_after);
  survey.shift = shift / change::survey_scale(before.cols);
  if (shift != cv::Point2d()) {
    cv::Mat lit;
    cv::multiply(a, light, lit, 1, CV_32F);
    a = change::undo_shift(lit, shift);
    light = cv::Scalar::all(1);
    grey_after = grey_of(a, light);
  }
  const change::TextureChange texture =
      change::texture_change(grey_before, grey_after, 255 * exposure.mean);
  survey.displaced = texture.displaced;
  survey.exposure = exposure_change(exposure.mean, texture.contrast, cv::mean(grey_after)[0]);

  const cv::Mat difference = difference_of(b, a, light);
  const float threshold = change_threshold(difference);
  survey.noisy = threshold >= kSureDifference;
  cv::Mat changed = difference > threshold;
  cv::morphologyEx(changed, changed, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  survey.fraction = cv::countNonZero(changed) / static_cast<double>(changed.total());
  cv::resize(changed, survey.changed, before.size(), 0, 0, cv::INTER_NEAREST);
  return survey;
}

cv::Rect changed_region(const ChangeSurvey& survey, const cv::Rect& within, double least_part) {
  cv::Mat labels;
  const std::vector<Patch> patches = joined_patches(survey.changed(within), labels);
  int largest = 0;
  for (const Patch& patch : patches) largest = std::max(largest, patch.area);
  cv::Rect box;
  for (const Patch& patch : patches)
    if (patch.area >= least_part * largest) box |= patch.box;
  return box.empty() ? cv::Rect() : with_margin(box + within.tl(), survey.noisy) & within;
}

std::vector<cv::Rect> changed_places(const cv::Mat& weights, bool noisy) {
  cv::Mat labels;
  std::vector<Patch> patches = joined_patches(weights > 0, labels);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (const int label = labels.at<int>(y, x))
        patches[label - 1].weight += weights.at<float>(y, x);
  std::stable_sort(patches.begin(), patches.end(),
                   [](const Patch& a, const Patch& b) { return a.weight > b.weight; });
  std::vector<cv::Rect> places;
  for (const Patch& patch : patches)
    places.push_back(with_margin(patch.box, noisy) & cv::Rect({0, 0}, weights.size()));
  return places;
}

}  // namespace mbncc
