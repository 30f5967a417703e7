// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/change_cut.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "imaging/rectangles.hpp"
#include "learning/alignment/align_images.hpp"
#include "learning/change/arrivals.hpp"
#include "learning/change/moved_neighbour.hpp"
#include "learning/likelihood/background_likelihood.hpp"
#include "learning/likelihood/coloured_shadow.hpp"
#include "learning/likelihood/object_preference.hpp"
#include "learning/likelihood/predicted_platform.hpp"
#include "learning/likelihood/rim_preference.hpp"
#include "learning/segmentation/clean_map.hpp"
#include "learning/segmentation/cut_evidence.hpp"
#include "learning/segmentation/exclusion_votes.hpp"
#include "learning/segmentation/graph_cut.hpp"
#include "learning/segmentation/half_smoothness.hpp"
#include "learning/segmentation/intruders.hpp"
#include "learning/segmentation/smoothness.hpp"

namespace mbncc {
namespace {

constexpr float kViewLogOdds = 8;    // largest log-odds of one view in a cut of two views
constexpr float kForced = 1000;      // unary term of pixels under strokes
constexpr float kArrivalUnary = 12;  // log-likelihood ratio of the platform for arrivals
constexpr float kSurelyObject = 5;   // unary term from which a pixel is surely object
constexpr int kFewestPixels = 30;    // least pixels of a seed
constexpr double kLeastOwn = 0.5;    // least part of a map that remains without its shadow
constexpr float kCovered = 2;        // added for pixels that an intruder covers afterwards
constexpr int kCheckedBox = 7;       // [px] side of the square around a stroke's pixel
constexpr int kSpeck = 8;            // [px] smaller changed patches are noise
// Least light [0..1] that a shadow leaves. A grey object looks like shadowed platform; but an
// object was taken away, so while shadows explain the whole change, the next higher limit is tried.
constexpr std::array<float, 4> kDarkestShadows{likelihood::kDarkestShadow, 0.5F, 0.7F, 0.9F};

// Data of one cut. All images have the crop's size and own their memory, because the pair's
// images are much larger and a cut lives as long as its lesson.
class Cutter {
 public:
  Cutter(const alignment::AlignedPair& pair, const cv::Rect& crop, const cv::Rect& region)
      : window_(pair.window),
        crop_(crop),
        before_(pair.before(crop - pair.window.tl()).clone()),
        after_(pair.after(crop - pair.window.tl()).clone()),
        inside_(cv::Mat::zeros(crop.size(), CV_8UC1)),
        noise_(likelihood::learn_noise(pair)),
        platform_(change::ColourMixture::fit(pair.before, pair.trusted)) {
    inside_(region - crop.tl()).setTo(255);
  }

  void explain_background(float darkest_shadow = likelihood::kDarkestShadow) {
    background_ =
        likelihood::background_likelihood(before_, after_, noise_, platform_, darkest_shadow);
    shadow_like_ = darkest_shadow > likelihood::kDarkestShadow;
    coloured_shadow_ = likelihood::coloured_shadow(before_, after_, noise_.sigma(1));
  }

  // Finds the changed pixels from which the object's colours are first learned; false if there are
  // too few. `surveyed` is ChangeSurvey::changed of the whole image; it is empty without an image
  // after, because nothing can have moved or arrived.
  bool seed(const cv::Mat& surveyed) {
    map_ = (background_.changed > 0.5) & inside_;
    segmentation::remove_specks(map_, kSpeck);
    if (!surveyed.empty()) exclude_others(surveyed);
    segmentation::keep_main_groups(map_, background_.changed);
    return cv::countNonZero(map_) >= kFewestPixels;
  }

  void weigh_edges() {
    smoothness_ = segmentation::smoothness(before_, after_, noise_);
    half_ = segmentation::half_resolution(smoothness_);
  }

  void cut() {
    unary_ = preference();
    object_like_ = unary_ > kSurelyObject;
    unary_.setTo(-likelihood::kHighestPreference, ~inside_);
    cut_by_unary(smoothness_);
  }

  // half_ must be `smoothness` at half resolution.
  void cut_by_unary(const segmentation::Smoothness& smoothness) {
    coarse_ = segmentation::coarse_cut(unary_, half_);
    cv::Mat next = coarse_.clone();
    segmentation::refine_cut(unary_, smoothness, next);
    if (cv::countNonZero(next) < kFewestPixels) return;
    segmentation::keep_main_groups(next, cv::min(unary_, likelihood::kHighestPreference), kept_);
    map_ = next;
  }

  // Cuts again with local colours along the rim, because blur, demosaicing and compression spread
  // the change beyond the outline.
  void cut_rim() {
    const likelihood::RimPreference rim =
        likelihood::rim_preference(before_, after_, map_, noise_.sigma(1));
    unary_ = unary_ + rim.log_odds;
    unary_.setTo(-likelihood::kHighestPreference, ~inside_);
    cut_by_unary(smoothness_);
  }

  void clean() {
    map_ = segmentation::clean_map(map_, cv::min(unary_, likelihood::kHighestPreference), kept_);
    if (!include_.empty()) map_ = (map_ | include_) & ~exclude_;
  }

  // A further cut with painted pixels as hard constraints; pixels that resemble excluded ones are
  // removed as well. Smoothness does not extend a stroke to its neighbours, because a thin part may
  // be next to a gap.
  Cutter painted(const cv::Mat& include, const cv::Mat& exclude) const {
    Cutter next = *this;
    next.include_ = include(crop_);
    next.exclude_ = exclude(crop_);
    next.inside_ = cv::Mat(inside_ | next.include_);
    // A part that a stroke separates from the rest still belongs to the object.
    next.kept_ = next.include_ | (map_ & ~next.exclude_);
    next.unary_ = cv::Mat(
        unary_ - segmentation::exclusion_votes({before_, after_, unary_, map_}, next.exclude_));
    next.unary_.setTo(kForced, next.include_);
    next.unary_.setTo(-kForced, next.exclude_);
    const segmentation::Smoothness free = segmentation::with_free_rim(
        segmentation::with_free_rim(smoothness_, next.include_), next.exclude_);
    next.half_ = segmentation::half_resolution(free);
    next.cut_by_unary(free);
    next.clean();
    return next;
  }

  // A further cut that includes the evidence of another view.
  Cutter informed(const cv::Mat& preference) const {
    Cutter next = *this;
    next.other_view_ = preference(crop_);
    next.cut();
    next.clean();
    return next;
  }

  cv::Mat full_size_map(const cv::Size& size) const {
    cv::Mat map = cv::Mat::zeros(size, CV_8UC1);
    map_.copyTo(map(crop_));
    return map;
  }

  cv::Mat full_size_preference(const cv::Size& size) const {
    cv::Mat preference(size, CV_32FC1, cv::Scalar(-kViewLogOdds));
    clipped(unary_).copyTo(preference(crop_));
    return preference;
  }

  CutEvidence evidence() const {
    const cv::Mat room = intruders_.empty() ? inside_ : cv::Mat(inside_ & ~intruders_);
    CutEvidence evidence =
        segmentation::cut_evidence({map_, coarse_, room, unary_, background_.changed, object_like_,
                                    kept_, intruders_, confirmed()},
                                   smoothness_, half_);
    evidence.shadow_like = shadow_like_;
    return evidence;
  }

 private:
  // Arrivals exist only in the image after: their place in the image before is platform.
  void exclude(cv::Mat arrivals) {
    if (cv::countNonZero(arrivals) == 0) return;
    map_.setTo(0, arrivals);
    cv::dilate(arrivals, arrivals, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}));
    arrivals.setTo(0, map_);
    background_.changed.setTo(0, arrivals);
    background_.log_ratio.setTo(kArrivalUnary, arrivals);
  }

  void exclude_others(const cv::Mat& surveyed) {
    if (cv::countNonZero((background_.changed > 0.5) & ~inside_) >= kFewestPixels) {
      exclude_moved_neighbours();
      exclude_intruders(segmentation::reaching_border(surveyed(window_))(crop_ - window_.tl()));
    }
    exclude(change::find_arrivals(before_, after_, map_, platform_));
  }

  // Called, like exclude_intruders(), only if the change extends beyond the region, because the
  // object lies inside it.
  void exclude_moved_neighbours() {
    const cv::Mat changed = background_.changed > 0.5;
    const cv::Mat moved = change::moved_neighbours(before_, after_, changed, noise_.sigma(1));
    map_.setTo(0, moved);
    background_.changed.setTo(0, moved);
    background_.log_ratio.setTo(kArrivalUnary, moved);
  }

  // Pixels that an intruder covers afterwards can be classified only by their colour before.
  void exclude_intruders(const cv::Mat& from_afar) {
    const cv::Mat changed = background_.changed > 0.5;
    intruders_ = segmentation::find_intruders(before_, after_, changed,
                                              changed & ~inside_ & from_afar, platform_, noise_);
    if (cv::countNonZero(intruders_) == 0) return;
    map_.setTo(0, intruders_);
    segmentation::remove_specks(map_, kSpeck);
    cv::Mat rim;
    cv::dilate(intruders_, rim, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
    intruders_ |= rim & ~map_;
    background_.changed.setTo(0, intruders_);
    cv::Mat platform;
    cv::log(likelihood::relative_density(platform_, before_) + 1e-3, platform);
    platform = cv::min(platform + kCovered, kArrivalUnary);
    platform.copyTo(background_.log_ratio, intruders_);
  }

  // Clipped log-odds of one view in a cut of both, so that no pixel dominates the other view.
  static cv::Mat clipped(const cv::Mat& unary) {
    return cv::max(cv::min(unary, kViewLogOdds), -kViewLogOdds);
  }

  // Pixels near the strokes were checked by the operator as well.
  cv::Mat confirmed() const {
    if (include_.empty()) return {};
    cv::Mat confirmed;
    cv::dilate(include_ | exclude_, confirmed, cv::Mat::ones(kCheckedBox, kCheckedBox, CV_8U));
    return confirmed;
  }

  // The part of the map that the object's colours are learned from: without shadows, unless most of
  // it has the shadowed platform's colour, because the object itself may have it.
  cv::Mat own_colours() const {
    const cv::Mat own = map_ & ~coloured_shadow_;
    return cv::countNonZero(own) < kLeastOwn * cv::countNonZero(map_) ? map_ : own;
  }

  // Log-odds of the object, whose colours are learned from the current map; outside the region as
  // well.
  cv::Mat preference() const {
    const change::ColourMixture object = change::ColourMixture::fit(
        before_, own_colours(), likelihood::colour_weights(background_.changed, map_));
    cv::Mat unary = likelihood::object_preference(before_, object, background_.log_ratio,
                                                  coarse_.empty() ? cv::Mat() : map_);
    if (!other_view_.empty()) unary = clipped(unary) + other_view_;
    return unary;
  }

  cv::Rect window_;  // of the aligned pair
  cv::Rect crop_;
  cv::Mat before_, after_, inside_;
  likelihood::NoiseModel noise_;
  change::ColourMixture platform_;
  likelihood::BackgroundLikelihood background_;
  cv::Mat coloured_shadow_;                     // CV_8UC1
  bool shadow_like_ = false;                    // see CutEvidence
  segmentation::Smoothness smoothness_, half_;  // half_: at half resolution
  cv::Mat unary_, coarse_, map_;
  cv::Mat object_like_;        // see FinishedCut
  cv::Mat intruders_;          // empty, or of the crop's size
  cv::Mat other_view_;         // empty, or of the crop's size
  cv::Mat include_, exclude_;  // both empty, or both of the crop's size
  cv::Mat kept_;               // CV_8UC1 or empty: groups that lie there belong to the object
};

ChangeCut result_of(const std::shared_ptr<const Cutter>& cutter, const cv::Size& size) {
  return {cutter->full_size_map(size), cutter->evidence(),
          [cutter, size] { return cutter->full_size_preference(size); },
          [cutter, size](const cv::Mat& include, const cv::Mat& exclude) {
            return result_of(std::make_shared<Cutter>(cutter->painted(include, exclude)), size);
          },
          [cutter, size](const cv::Mat& preference) {
            return result_of(std::make_shared<Cutter>(cutter->informed(preference)), size);
          }};
}

cv::Rect crop_of(const cv::Rect& region, const cv::Size& image) {
  const int margin = std::max(6, std::max(region.width, region.height) / 20);
  return imaging::grown(region, margin) & cv::Rect({0, 0}, image);
}

ChangeCut cut(const std::shared_ptr<Cutter>& cutter, const cv::Size& size, int iterations,
              const BeforeCut& before_cut) {
  cutter->weigh_edges();
  for (int i = 0; i < iterations; ++i) {
    if (before_cut) before_cut(i);
    cutter->cut();
  }
  cutter->cut_rim();
  cutter->clean();
  return result_of(cutter, size);
}

ChangeCut nothing(const cv::Size& size) {
  CutEvidence evidence;
  evidence.region_span = 0;
  return {cv::Mat::zeros(size, CV_8UC1), evidence, {}, {}, {}};
}

}  // namespace

ChangeCut change_cut(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                     const cv::Mat& changed, int iterations, int max_shift,
                     const BeforeCut& before_cut) {
  const auto cutter =
      std::make_shared<Cutter>(alignment::align_images(before, after, region, changed, max_shift),
                               crop_of(region, before.size()), region);
  const auto leaves_an_object = [&](float darkest_shadow) {
    cutter->explain_background(darkest_shadow);
    return cutter->seed(changed);
  };
  if (std::none_of(kDarkestShadows.begin(), kDarkestShadows.end(), leaves_an_object))
    return nothing(before.size());
  return cut(cutter, before.size(), iterations, before_cut);
}

ChangeCut region_cut(const cv::Mat& before, const cv::Rect& region, int iterations,
                     const BeforeCut& before_cut) {
  const auto cutter = std::make_shared<Cutter>(likelihood::predict_platform(before, region),
                                               crop_of(region, before.size()), region);
  cutter->explain_background();
  if (!cutter->seed(cv::Mat())) return nothing(before.size());
  return cut(cutter, before.size(), iterations, before_cut);
}

}  // namespace mbncc
