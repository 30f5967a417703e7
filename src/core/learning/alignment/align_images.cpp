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
constexpr float kDark = 30;             // [grey levels, three channels] noise on black is no shadow
constexpr double kLeastQuiet = 0.15;    // part of the ring
constexpr double kFewestQuiet = 2000;   // [px] enough for a fit
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

// Difference of the images after correction by `light`, summed over channels, averaged over 7 x 7
// pixels.
cv::Mat remaining_difference(const cv::Mat& before, const cv::Mat& after, const Light& light) {
  cv::Mat difference(before.size(), CV_32FC1);
  imaging::for_each_strip(before.rows, [&](const cv::Range& rows) {
    cv::Mat lit = apply_light(after, light, rows), part = difference.rowRange(rows);
    cv::absdiff(floats(before.rowRange(rows)), lit, lit);
    cv::transform(lit, part, cv::Matx13f(1, 1, 1));
  });
  cv::blur(difference, difference, {7, 7});
  return difference;
}

// Pixels whose brightness over 7 x 7 pixels differs as in a shadow that lies in one image only;
// both are CV_32FC3.
cv::Mat shadows_of(const cv::Mat& before, const cv::Mat& lit) {
  const auto brightness = [](const cv::Mat& image) {
    cv::Mat sum;
    cv::transform(image, sum, cv::Matx13f(1, 1, 1));
    cv::blur(sum, sum, {7, 7});
    return sum;
  };
  const cv::Mat b = brightness(before), a = brightness(lit);
  return cv::abs(b - a) > kShadow * (cv::max(b, a) + kDark);
}

// Ring pixels without `blobs` and their surroundings; all of them if hardly any would remain,
// because then the fit itself was wrong.
cv::Mat without_blobs(cv::Mat blobs, const cv::Mat& ring) {
  cv::dilate(blobs, blobs, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9}));
  const cv::Mat quiet = ring & ~blobs;
  const double least = std::max(kFewestQuiet, kLeastQuiet * cv::countNonZero(ring));
  return cv::countNonZero(quiet) > least ? quiet : ring;
}

// Ring pixels in patches that still differ (a moved neighbour, the gripper) are excluded.
cv::Mat without_changed_blobs(const cv::Mat& difference, const cv::Mat& ring) {
  std::vector<float> values;
  for (int y = 0; y < ring.rows; y += 3)
    for (int x = 0; x < ring.cols; x += 3)
      if (ring.at<uchar>(y, x)) values.push_back(difference.at<float>(y, x));
  return without_blobs(difference > std::max(12.F, 3.5F * numeric::median(values)), ring);
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
    trusted_ = without_blobs(shadows_of(before, lit_), trusted_);
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
