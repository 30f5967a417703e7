#include "learning/align_pictures.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "learning/camera_shift.hpp"
#include "learning/photometric_fit.hpp"
#include "learning/rectangles.hpp"
#include "learning/statistics.hpp"

namespace mbncc {
namespace {

constexpr int kLeastRing = 40;          // [px] width of the ring
constexpr uchar kGlare = 247;           // [grey levels] above, a pixel may be clipped
constexpr double kLeastTrusted = 0.15;  // of the window, below which the ring is too thin

cv::Mat floats(const cv::Mat& picture) {
  cv::Mat values;
  picture.convertTo(values, CV_32F);
  return values;
}

cv::Mat brightest_channel(const cv::Mat& picture) {
  cv::Mat channels[3];
  cv::split(picture, channels);
  return cv::max(cv::max(channels[0], channels[1]), channels[2]);
}

cv::Mat glare_of(const cv::Mat& before, const cv::Mat& after) {
  return (brightest_channel(before) > kGlare) | (brightest_channel(after) > kGlare);
}

// Where the platform should look the same in both pictures.
cv::Mat ring_of(const cv::Rect& window, const cv::Rect& region, const cv::Mat& changed) {
  cv::Mat ring(window.size(), CV_8UC1, cv::Scalar(255));
  const cv::Rect inner = (grown(region, 4) - window.tl()) & cv::Rect({0, 0}, window.size());
  ring(inner).setTo(0);
  if (cv::countNonZero(ring) >= kLeastTrusted * window.area()) return ring;
  cv::Mat near_change;
  cv::dilate(changed(window), near_change, cv::getStructuringElement(cv::MORPH_ELLIPSE, {15, 15}));
  return ~near_change;
}

// Ring pixels in patches that still differ (a moved neighbour, the gripper) are no platform.
// Unless hardly anything would be left: then the fit itself was wrong.
cv::Mat without_changed_blobs(const cv::Mat& before, const cv::Mat& lit, const cv::Mat& ring) {
  cv::Mat distance, difference;
  cv::absdiff(before, lit, distance);
  cv::transform(distance, difference, cv::Matx13f(1, 1, 1));
  cv::blur(difference, difference, {7, 7});
  std::vector<float> values;
  for (int y = 0; y < ring.rows; y += 3)
    for (int x = 0; x < ring.cols; x += 3)
      if (ring.at<uchar>(y, x)) values.push_back(difference.at<float>(y, x));
  cv::Mat blobs = difference > std::max(12.F, 3.5F * median(values));
  cv::dilate(blobs, blobs, cv::getStructuringElement(cv::MORPH_ELLIPSE, {9, 9}));
  const cv::Mat quiet = ring & ~blobs;
  return cv::countNonZero(quiet) > 0.3 * cv::countNonZero(ring) ? quiet : ring;
}

// A clipped pixel says only "at least so bright": where the other picture is bright as well, take
// its value.
void censor_glare(const cv::Mat& before, const cv::Mat& after, cv::Mat& lit) {
  for (int y = 0; y < lit.rows; ++y) {
    const auto* b = before.ptr<float>(y);
    const auto* a = after.ptr<float>(y);
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
      : before_(before), window_(window), ring_(ring) {
    // A margin keeps the border's replication out of the window when a shift is undone.
    source_window_ = grown(window, 10) & cv::Rect({0, 0}, after.size());
    source_ = floats(after(source_window_));
    moved_ = source_(window_ - source_window_.tl());
    trusted_ = ring_;
  }

  void fit_light_to_ring() {
    trusted_ = without_changed_blobs(
        before_, apply_light(moved_, fit_light(before_, moved_, ring_, false)), ring_);
    light_ = fit_light(before_, moved_, trusted_, true);
    lit_ = apply_light(moved_, light_);
  }

  // The ring's changed patches depend on the shift and the other way round: two passes.
  void undo_camera_shift(double max_shift) {
    shift_ = estimate_shift(smooth_luminance(before_), smooth_luminance(lit_), trusted_, max_shift);
    if (shift_ == cv::Point2d()) return;
    moved_ = undo_shift(source_, shift_)(window_ - source_window_.tl());
    fit_light_to_ring();
  }

  AlignedPair result() {
    censor_glare(before_, moved_, lit_);
    return {window_, before_, lit_, trusted_, shift_};
  }

 private:
  cv::Mat before_;
  cv::Rect window_, source_window_;
  cv::Mat ring_, source_, moved_, trusted_, lit_;
  Light light_;
  cv::Point2d shift_;
};

}  // namespace

AlignedPair align_pictures(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                           const cv::Mat& changed, double max_shift) {
  const int ring_width = std::max(kLeastRing, std::max(region.width, region.height) / 2);
  const cv::Rect window = grown(region, ring_width) & cv::Rect({0, 0}, before.size());
  const cv::Mat ring = ring_of(window, region, changed) & ~glare_of(before(window), after(window));
  Alignment alignment(floats(before(window)), after, window, ring);
  alignment.fit_light_to_ring();
  alignment.undo_camera_shift(max_shift);
  return alignment.result();
}

}  // namespace mbncc
