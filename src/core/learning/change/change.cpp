// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/change.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/strips.hpp"
#include "learning/alignment/image_shift.hpp"
#include "learning/alignment/phase_shift.hpp"
#include "learning/change/exposure.hpp"
#include "learning/change/survey_size.hpp"
#include "learning/change/texture_change.hpp"
#include "numeric/order_statistics.hpp"

namespace mbncc {
namespace {

// [grey levels, summed over channels] Least threshold of a changed pixel, above usual noise.
constexpr float kLeastDifference = 18;
constexpr float kNoiseFactor = 5;  // threshold of a changed pixel, in median differences
// [grey levels, summed over channels] Largest threshold of a changed pixel.
constexpr float kSureDifference = 45;
constexpr double kClearGain = 0.8;  // a shift must reduce the difference below this part
constexpr int kSampling = 2;        // [px] sampling step for medians
constexpr double kBlackLevel = 10;  // [grey levels] possible black level of cameras

// CV_32FC1 of a CV_8UC3 image times `gain` per channel.
cv::Mat grey_of(const cv::Mat& image, const cv::Scalar& gain) {
  cv::Mat grey(image.size(), CV_32FC1), strip;
  imaging::for_each_strip(image.rows, [&](const cv::Range& rows) {
    cv::multiply(image.rowRange(rows), gain, strip, 1, CV_32F);
    cv::Mat part = grey.rowRange(rows);
    cv::cvtColor(strip, part, cv::COLOR_BGR2GRAY);
  });
  return grey;
}

// Mean difference of two grey images; a pixel counts at most kLeastDifference.
double mean_difference(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat difference;
  cv::absdiff(before, after, difference);
  return cv::mean(cv::min(difference, kLeastDifference))[0];
}

// Camera shift by phase correlation; (0, 0) if it does not clearly reduce the difference of the
// images.
cv::Point2d coarse_shift(const cv::Mat& before, const cv::Mat& after) {
  const cv::Point2d shift = alignment::phase_shift(before, after);
  const cv::Rect inner(before.cols / 4, before.rows / 4, before.cols / 2, before.rows / 2);
  const cv::Mat moved = alignment::undo_shift(after, shift);
  const bool explains = mean_difference(before(inner), moved(inner)) <
                        kClearGain * mean_difference(before(inner), after(inner));
  return explains ? shift : cv::Point2d();
}

// Difference of `before` and `after` times `gain`, summed over channels, averaged over 3 x 3
// pixels.
cv::Mat difference_of(const cv::Mat& before, const cv::Mat& after, const cv::Scalar& gain) {
  cv::Mat difference(before.size(), CV_32FC1), b, a;
  imaging::for_each_strip(before.rows, [&](const cv::Range& rows) {
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
  return std::clamp(kNoiseFactor * numeric::median(values), kLeastDifference, kSureDifference);
}

// Exposure ratio >= 1 of images that have the mean `brightness` after compensation. In dark images,
// another black level looks like another exposure, but does not change the contrast.
double exposure_change(double gain, double contrast, double brightness) {
  const auto factor = [](double ratio) { return std::max(ratio, 1 / std::max(ratio, 1e-3)); };
  const bool is_black_level = std::abs(1 - contrast) * brightness < kBlackLevel;
  return is_black_level ? std::min(factor(gain), factor(gain * contrast)) : factor(gain);
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
    a = alignment::undo_shift(lit, shift);
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

}  // namespace mbncc
