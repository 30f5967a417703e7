// SPDX-License-Identifier: BSD-3-Clause
#include "learning/alignment/align_images.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"
#include "imaging/strips.hpp"
#include "learning/alignment/camera_shift.hpp"
#include "learning/alignment/image_shift.hpp"
#include "learning/alignment/photometric_fit.hpp"
#include "numeric/order_statistics.hpp"

namespace mbncc::alignment {
namespace {

constexpr int kLeastRing = 40;          // [px] least width of the ring
constexpr uchar kGlare = 247;           // [grey levels] brighter pixels may be clipped
constexpr float kShadow = 0.15F;        // part of the light that a shadow takes at least
constexpr float kDark = 30;             // [grey levels, three channels] added to both images
constexpr double kLeastTrusted = 0.15;  // part of the window; a smaller ring is too thin

cv::Mat floats(const cv::Mat& image) {
  cv::Mat values;
  image.convertTo(values, CV_32F);
  return values;
}

cv::Mat glare_of(const cv::Mat& before, const cv::Mat& after) {
  cv::Mat channels[3];
  cv::split(cv::max(before, after), channels);
  return cv::max(cv::max(channels[0], channels[1]), channels[2]) > kGlare;
}

// Pixels where the platform should look the same in both images.
cv::Mat ring_of(const cv::Rect& window, const cv::Rect& region, const cv::Mat& changed) {
  cv::Mat ring(window.size(), CV_8UC1, cv::Scalar(255));
  const cv::Rect inner =
      (imaging::grown(region, 4) - window.tl()) & cv::Rect({0, 0}, window.size());
  ring(inner).setTo(0);
  if (cv::countNonZero(ring) >= kLeastTrusted * window.area()) return ring;
  cv::Mat near_change;
  cv::dilate(changed(window), near_change, cv::getStructuringElement(cv::MORPH_ELLIPSE, {15, 15}));
  return ~near_change;
}

// Differences of the images after correction by `light`, in 7 x 7 pixels.
struct RemainingDifference {
  cv::Mat any;    // CV_32FC1, mean sum of the channels' differences [grey levels]
  cv::Mat light;  // CV_32FC1, part of the light that one image has less
};

RemainingDifference remaining_difference(const cv::Mat& before, const cv::Mat& after,
                                         const Light& light) {
  cv::Mat any(before.size(), CV_32FC1), sums_before(before.size(), CV_32FC1),
      sums_after = sums_before.clone();
  imaging::for_each_strip(before.rows, [&](const cv::Range& rows) {
    const cv::Matx13f sum(1, 1, 1);
    cv::Mat lit = apply_light(after, light, rows), given = floats(before.rowRange(rows));
    cv::Mat part = any.rowRange(rows), part_before = sums_before.rowRange(rows),
            part_after = sums_after.rowRange(rows);
    cv::transform(lit, part_after, sum);
    cv::transform(given, part_before, sum);
    cv::absdiff(given, lit, lit);
    cv::transform(lit, part, sum);
  });
  for (cv::Mat* values : {&any, &sums_before, &sums_after}) cv::blur(*values, *values, {7, 7});
  const cv::Mat brighter = cv::max(sums_before, sums_after) + kDark;
  return {any, cv::abs(sums_before - sums_after) / brighter};
}

// Ring pixels in patches that still differ (a moved neighbour, the gripper, a shadow) are excluded,
// unless hardly any would remain, because then the fit itself was wrong.
cv::Mat without_changed_blobs(const RemainingDifference& difference, const cv::Mat& ring) {
  std::vector<float> values;
  for (int y = 0; y < ring.rows; y += 3)
    for (int x = 0; x < ring.cols; x += 3)
      if (ring.at<uchar>(y, x)) values.push_back(difference.any.at<float>(y, x));
  cv::Mat blobs = difference.any > std::max(12.F, 3.5F * numeric::median(values));
  blobs |= difference.light > kShadow;
  cv::dilate(blobs, blobs, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9}));
  const cv::Mat quiet = ring & ~blobs;
  return cv::countNonZero(quiet) > 0.15 * cv::countNonZero(ring) ? quiet : ring;
}

// A clipped pixel is only a lower bound of the brightness: if the other image is bright as well,
// its value is used.
void censor_glare(const cv::Mat& before, const cv::Mat& after, cv::Mat& lit) {
  cv::Mat row;
  for (int y = 0; y < lit.rows; ++y) {
    after.row(y).convertTo(row, CV_32F);
    const auto* b = before.ptr<float>(y);
    const auto* a = row.ptr<float>();
    auto* value = lit.ptr<float>(y);
    for (int i = 0; i < 3 * lit.cols; ++i) {
      value[i] = std::clamp(value[i], 0.F, 255.F);
      const bool after_clipped = a[i] > kGlare && (b[i] > value[i] || b[i] > 240);
      const bool before_clipped = a[i] <= kGlare && b[i] > 250 && value[i] > 238;
      if (after_clipped || before_clipped) value[i] = b[i];
    }
  }
}

class Alignment {
 public:
  Alignment(const cv::Mat& before, const cv::Mat& after, const cv::Rect& window,
            const cv::Mat& ring)
      : before_(before(window)), window_(window), ring_(ring) {
    // A margin keeps replicated borders out of the window when a shift is compensated.
    source_window_ = imaging::grown(window, 10) & cv::Rect({0, 0}, after.size());
    source_ = after(source_window_);
    moved_ = source_(window_ - source_window_.tl());
    trusted_ = ring_;
  }

  void fit_light_to_ring() {
    const Light constant = fit_light(before_, moved_, ring_, false);
    trusted_ = without_changed_blobs(remaining_difference(before_, moved_, constant), ring_);
    light_ = fit_light(before_, moved_, trusted_, true);
    lit_ = apply_light(moved_, light_);
  }

  // The ring's changed patches and the shift depend on each other, so there are two passes.
  void undo_camera_shift(double max_shift) {
    shift_ = estimate_shift(smooth_luminance(before_), smooth_luminance(lit_), trusted_, max_shift);
    if (shift_ == cv::Point2d()) return;
    moved_ = undo_shift(floats(source_), shift_)(window_ - source_window_.tl());
    fit_light_to_ring();
  }

  AlignedPair result() {
    const cv::Mat before = floats(before_);
    censor_glare(before, moved_, lit_);
    return {window_, before, lit_, trusted_, shift_};
  }

 private:
  cv::Mat before_;
  cv::Rect window_, source_window_;
  cv::Mat ring_, source_, trusted_, lit_;
  cv::Mat moved_;  // CV_8UC3, or CV_32FC3 once a shift was undone
  Light light_;
  cv::Point2d shift_;
};

}  // namespace

AlignedPair align_images(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                         const cv::Mat& changed, double max_shift) {
  const int ring_width = std::max(kLeastRing, std::max(region.width, region.height) / 2);
  const cv::Rect window = imaging::grown(region, ring_width) & cv::Rect({0, 0}, before.size());
  const cv::Mat ring = ring_of(window, region, changed) & ~glare_of(before(window), after(window));
  Alignment alignment(before, after, window, ring);
  alignment.fit_light_to_ring();
  alignment.undo_camera_shift(max_shift);
  return alignment.result();
}

}  // namespace mbncc::alignment
