#include "mbncc/learning/change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/camera_shift.hpp"
#include "learning/phase_shift.hpp"
#include "learning/rectangles.hpp"
#include "learning/statistics.hpp"
#include "learning/strips.hpp"

namespace mbncc {
namespace {

constexpr int kSurveyWidth = 320;       // [px]
constexpr float kLeastDifference = 18;  // [grey levels, summed over channels] above usual noise
constexpr float kNoiseFactor = 5;       // a change stands out from the median difference this much
constexpr float kSureDifference = 45;   // [likewise] a change, however much else differs
constexpr double kMargin = 0.15;        // of a changed region's longer side
constexpr double kNoisyMargin = 0.6;    // likewise, where noise hides part of the change
constexpr double kClearGain = 0.8;      // a shift must lower the difference to this part
constexpr int kGap = 9;                 // [px] pieces nearer than this belong together
constexpr int kSampling = 2;            // [px] of the survey, for medians
constexpr int kTextureBox = 15;         // [px] of the survey: texture is compared in such squares
constexpr double kTextured = 9;         // [grey levels^2] variance above which a square has texture
constexpr double kSameTexture = 0.5;    // correlation of squares that show the same

cv::Mat reduced(const cv::Mat& picture, double scale) {
  cv::Mat small;
  cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
  return small;
}

// CV_32FC1 of a CV_8UC3 picture times `gain` per channel.
cv::Mat grey_of(const cv::Mat& picture, const cv::Scalar& gain) {
  cv::Mat grey(picture.size(), CV_32FC1), strip;
  for_each_strip(picture.rows, [&](const cv::Range& rows) {
    cv::multiply(picture.rowRange(rows), gain, strip, 1, CV_32F);
    cv::Mat part = grey.rowRange(rows);
    cv::cvtColor(strip, part, cv::COLOR_BGR2GRAY);
  });
  return grey;
}

using Ratios = std::array<std::vector<float>, 3>;  // of brightness, per channel

// Dark and saturated pixels say nothing.
Ratios brightness_ratios(const cv::Mat& before, const cv::Mat& after) {
  Ratios ratios;
  for (int y = 0; y < before.rows; y += kSampling) {
    const auto* b = before.ptr<cv::Vec3b>(y);
    const auto* a = after.ptr<cv::Vec3b>(y);
    for (int x = 0; x < before.cols; x += kSampling)
      for (int c = 0; c < 3; ++c)
        if (a[x][c] > 10 && a[x][c] < 245 && b[x][c] < 245)
          ratios[c].push_back(static_cast<float>(b[x][c]) / a[x][c]);
  }
  return ratios;
}

cv::Vec3f exposure_ratio(Ratios& ratios) {
  constexpr std::size_t kFewest = 100;
  cv::Vec3f gain(1, 1, 1);
  for (int c = 0; c < 3; ++c)
    if (ratios[c].size() > kFewest) gain[c] = median(ratios[c]);
  return gain;
}

double mean_of(const cv::Vec3f& values) {
  return (values[0] + values[1] + values[2]) / 3;
}

struct Exposure {
  cv::Vec3f gain;         // that makes the picture after as bright as the one before
  double unevenness = 1;  // largest over smallest gain of the picture's quarters
};

Exposure exposure_of(const cv::Mat& before, const cv::Mat& after) {
  const cv::Size half(before.cols / 2, before.rows / 2);
  double low = 1e9, high = 0;
  Ratios all;
  for (const int x : {0, before.cols - half.width})
    for (const int y : {0, before.rows - half.height}) {
      const cv::Rect quarter({x, y}, half);
      Ratios ratios = brightness_ratios(before(quarter), after(quarter));
      for (int c = 0; c < 3; ++c) all[c].insert(all[c].end(), ratios[c].begin(), ratios[c].end());
      const double gain = mean_of(exposure_ratio(ratios));
      low = std::min(low, gain);
      high = std::max(high, gain);
    }
  return {exposure_ratio(all), high / std::max(low, 1e-3)};
}

// Mean difference of two grey pictures; large ones count no more than kLeastDifference.
double mean_difference(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat difference;
  cv::absdiff(before, after, difference);
  return cv::mean(cv::min(difference, kLeastDifference))[0];
}

// By phase correlation, believed only when it explains the pictures.
cv::Point2d coarse_shift(const cv::Mat& before, const cv::Mat& after) {
  const cv::Point2d shift = phase_shift(before, after);
  const cv::Rect inner(before.cols / 4, before.rows / 4, before.cols / 2, before.rows / 2);
  const cv::Mat moved = undo_shift(after, shift);
  const bool explains = mean_difference(before(inner), moved(inner)) <
                        kClearGain * mean_difference(before(inner), after(inner));
  return explains ? shift : cv::Point2d();
}

// Difference of the pictures, the one after times `gain`, summed over channels, averaged over
// 3 x 3.
cv::Mat difference_of(const cv::Mat& before, const cv::Mat& after, const cv::Scalar& gain) {
  cv::Mat difference(before.size(), CV_32FC1), b, a;
  for_each_strip(before.rows, [&](const cv::Range& rows) {
    before.rowRange(rows).convertTo(b, CV_32F);
    cv::multiply(after.rowRange(rows), gain, a, 1, CV_32F);
    cv::absdiff(b, a, a);
    cv::Mat part = difference.rowRange(rows);
    cv::transform(a, part, cv::Matx13f(1, 1, 1));
  });
  cv::blur(difference, difference, {3, 3});
  return difference;
}

// Difference from which on a pixel changed, as the usual one tells.
float change_threshold(const cv::Mat& difference) {
  std::vector<float> values;
  for (int y = 0; y < difference.rows; y += kSampling)
    for (int x = 0; x < difference.cols; x += kSampling)
      values.push_back(difference.at<float>(y, x));
  return std::clamp(kNoiseFactor * median(values), kLeastDifference, kSureDifference);
}

// Means over small squares of a product of two pictures.
cv::Mat mean_product(const cv::Mat& a, const cv::Mat& b) {
  cv::Mat mean = a.mul(b);
  cv::boxFilter(mean, mean, CV_32F, {kTextureBox, kTextureBox});
  return mean;
}

cv::Mat box_mean(const cv::Mat& values) {
  cv::Mat mean;
  cv::boxFilter(values, mean, CV_32F, {kTextureBox, kTextureBox});
  return mean;
}

struct Texture {
  int squares = 0, displaced = 0;

  void count(bool is_displaced) {
    ++squares;
    displaced += is_displaced;
  }
  double displaced_part() const {
    return squares == 0 ? 0 : displaced / static_cast<double>(squares);
  }
};

// Light and exposure leave the correlation of small squares alone; a moved camera does not. It
// displaces the texture of both pictures; of a scene that many things left, the rest stays.
double displaced_part(const cv::Mat& before, const cv::Mat& after) {
  const cv::Mat mean_b = box_mean(before), mean_a = box_mean(after);
  const cv::Mat bb = mean_product(before, before), aa = mean_product(after, after),
                ba = mean_product(before, after);
  Texture textured_before, textured_after;
  for (int y = 0; y < before.rows; ++y) {
    const auto *b = mean_b.ptr<float>(y), *a = mean_a.ptr<float>(y);
    for (int x = 0; x < before.cols; ++x) {
      const double vb = bb.at<float>(y, x) - b[x] * b[x], va = aa.at<float>(y, x) - a[x] * a[x];
      if (std::max(vb, va) < kTextured) continue;
      const float covariance = ba.at<float>(y, x) - b[x] * a[x];
      const bool displaced =
          covariance < kSameTexture * std::sqrt(std::max(kTextured, vb) * std::max(kTextured, va));
      if (vb >= kTextured) textured_before.count(displaced);
      if (va >= kTextured) textured_after.count(displaced);
    }
  }
  return std::min(textured_before.displaced_part(), textured_after.displaced_part());
}

struct Patch {
  cv::Rect box;
  int area = 0;       // [px]
  double weight = 0;  // sum over its pixels
};

// Groups of changed pixels, pieces that are near each other joined. `labels` tells them apart: the
// result's index, and one more.
std::vector<Patch> joined_patches(const cv::Mat& changed, cv::Mat& labels) {
  cv::Mat joined, stats, centres;
  cv::morphologyEx(changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
  std::vector<Patch> patches;
  for (int i = 1; i < count; ++i)
    patches.push_back({{stats.at<int>(i, cv::CC_STAT_LEFT), stats.at<int>(i, cv::CC_STAT_TOP),
                        stats.at<int>(i, cv::CC_STAT_WIDTH), stats.at<int>(i, cv::CC_STAT_HEIGHT)},
                       stats.at<int>(i, cv::CC_STAT_AREA)});
  return patches;
}

cv::Rect with_margin(const cv::Rect& box, bool noisy) {
  const double part = noisy ? kNoisyMargin : kMargin;
  return grown(box, std::max(8, static_cast<int>(part * std::max(box.width, box.height))));
}

}  // namespace

ChangeSurvey survey_change(const cv::Mat& before, const cv::Mat& after) {
  const double scale = std::min(1.0, static_cast<double>(kSurveyWidth) / before.cols);
  const cv::Mat b = reduced(before, scale);
  cv::Mat a = reduced(after, scale);
  ChangeSurvey survey;
  const auto [gain, unevenness] = exposure_of(b, a);
  const double exposure = mean_of(gain);
  survey.exposure = std::max(exposure, 1 / std::max(exposure, 1e-3));
  survey.unevenness = unevenness;
  cv::Scalar light(gain[0], gain[1], gain[2]);
  const cv::Mat grey_before = grey_of(b, cv::Scalar::all(1));
  cv::Mat grey_after = grey_of(a, light);
  const cv::Point2d shift = coarse_shift(grey_before, grey_after);
  survey.shift = shift / scale;
  if (shift != cv::Point2d()) {
    cv::Mat lit;
    cv::multiply(a, light, lit, 1, CV_32F);
    a = undo_shift(lit, shift);
    light = cv::Scalar::all(1);
    grey_after = grey_of(a, light);
  }
  survey.displaced = displaced_part(grey_before, grey_after);

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
