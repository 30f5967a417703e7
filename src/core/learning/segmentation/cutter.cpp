// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/cutter.hpp"

#include <algorithm>
#include <memory>
#include <opencv2/imgproc.hpp>

#include "imaging/rectangles.hpp"
#include "learning/change/arrivals.hpp"
#include "learning/change/moved_neighbour.hpp"
#include "learning/likelihood/coloured_shadow.hpp"
#include "learning/likelihood/object_preference.hpp"
#include "learning/likelihood/rim_preference.hpp"
#include "learning/segmentation/clean_map.hpp"
#include "learning/segmentation/cut_evidence.hpp"
#include "learning/segmentation/exclusion_votes.hpp"
#include "learning/segmentation/graph_cut.hpp"
#include "learning/segmentation/half_smoothness.hpp"
#include "learning/segmentation/intruders.hpp"
#include "learning/segmentation/unconfirmed_hole.hpp"

namespace mbncc::segmentation {
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

ObjectCut result_of(const std::shared_ptr<const Cutter>& cutter, const cv::Size& size) {
  return {cutter->full_size_map(size), cutter->evidence(),
          [cutter, size] { return cutter->full_size_preference(size); },
          [cutter, size](const cv::Mat& include, const cv::Mat& exclude) {
            return result_of(std::make_shared<Cutter>(cutter->painted(include, exclude)), size);
          },
          [cutter, size](const cv::Mat& preference) {
            return result_of(std::make_shared<Cutter>(cutter->informed(preference)), size);
          }};
}

}  // namespace

Cutter::Cutter(const alignment::AlignedPair& pair, const cv::Rect& crop, const cv::Rect& region)
    : window_(pair.window),
      crop_(crop),
      before_(pair.before(crop - pair.window.tl()).clone()),
      after_(pair.after(crop - pair.window.tl()).clone()),
      inside_(cv::Mat::zeros(crop.size(), CV_8UC1)),
      noise_(likelihood::learn_noise(pair)),
      platform_(change::ColourMixture::fit(pair.before, pair.trusted)),
      verified_(!pair.predicted) {
  inside_(region - crop.tl()).setTo(255);
}

void Cutter::explain_background(float darkest_shadow) {
  background_ =
      likelihood::background_likelihood(before_, after_, noise_, platform_, darkest_shadow);
  shadow_like_ = darkest_shadow > likelihood::kDarkestShadow;
  coloured_shadow_ = likelihood::coloured_shadow(before_, after_, noise_.sigma(1));
}

bool Cutter::seed(const cv::Mat& surveyed) {
  map_ = (background_.changed > 0.5) & inside_;
  remove_specks(map_, kSpeck);
  if (!surveyed.empty()) exclude_others(surveyed);
  keep_main_groups(map_, background_.changed);
  return cv::countNonZero(map_) >= kFewestPixels;
}

void Cutter::weigh_edges() {
  smoothness_ = smoothness(before_, after_, noise_);
  half_ = half_resolution(smoothness_);
}

void Cutter::cut() {
  unary_ = preference();
  object_like_ = unary_ > kSurelyObject;
  unary_.setTo(-likelihood::kHighestPreference, ~inside_);
  cut_by_unary(smoothness_);
}

void Cutter::cut_by_unary(const Smoothness& smoothness) {
  coarse_ = coarse_cut(unary_, half_);
  cv::Mat next = coarse_.clone();
  refine_cut(unary_, smoothness, next);
  if (cv::countNonZero(next) < kFewestPixels) return;
  keep_main_groups(next, cv::min(unary_, likelihood::kHighestPreference), kept_);
  map_ = next;
}

void Cutter::cut_rim() {
  const likelihood::RimPreference rim =
      likelihood::rim_preference(before_, after_, map_, noise_.sigma(1));
  unary_ = unary_ + rim.log_odds;
  unary_.setTo(-likelihood::kHighestPreference, ~inside_);
  cut_by_unary(smoothness_);
}

void Cutter::clean() {
  map_ = clean_map(map_, cv::min(unary_, likelihood::kHighestPreference), kept_);
  if (!include_.empty()) map_ = (map_ | include_) & ~exclude_;
}

Cutter Cutter::painted(const cv::Mat& include, const cv::Mat& exclude) const {
  Cutter next = *this;
  next.include_ = include(crop_);
  next.exclude_ = exclude(crop_);
  next.inside_ = cv::Mat(inside_ | next.include_);
  // A part that a stroke separates from the rest still belongs to the object.
  next.kept_ = next.include_ | (map_ & ~next.exclude_);
  next.unary_ = cv::Mat(unary_ - exclusion_votes({before_, after_, unary_, map_}, next.exclude_));
  next.unary_.setTo(kForced, next.include_);
  next.unary_.setTo(-kForced, next.exclude_);
  const Smoothness free = with_free_rim(with_free_rim(smoothness_, next.include_), next.exclude_);
  next.half_ = half_resolution(free);
  next.cut_by_unary(free);
  next.clean();
  return next;
}

Cutter Cutter::informed(const cv::Mat& preference) const {
  Cutter next = *this;
  next.other_view_ = preference(crop_);
  next.cut();
  next.clean();
  return next;
}

cv::Mat Cutter::full_size_map(const cv::Size& size) const {
  cv::Mat map = cv::Mat::zeros(size, CV_8UC1);
  map_.copyTo(map(crop_));
  return map;
}

cv::Mat Cutter::full_size_preference(const cv::Size& size) const {
  cv::Mat preference(size, CV_32FC1, cv::Scalar(-kViewLogOdds));
  clipped(unary_).copyTo(preference(crop_));
  return preference;
}

CutEvidence Cutter::evidence() const {
  const cv::Mat room = intruders_.empty() ? inside_ : cv::Mat(inside_ & ~intruders_);
  CutEvidence evidence = cut_evidence({map_, coarse_, room, unary_, background_.changed,
                                       object_like_, kept_, intruders_, confirmed()},
                                      smoothness_, half_);
  evidence.shadow_like = shadow_like_;
  evidence.verified = verified_;
  evidence.unconfirmed_hole = unconfirmed_hole(map_, before_, after_, exclude_);
  return evidence;
}

void Cutter::exclude(cv::Mat arrivals) {
  if (cv::countNonZero(arrivals) == 0) return;
  map_.setTo(0, arrivals);
  cv::dilate(arrivals, arrivals, cv::getStructuringElement(cv::MORPH_ELLIPSE, {7, 7}));
  arrivals.setTo(0, map_);
  background_.changed.setTo(0, arrivals);
  background_.log_ratio.setTo(kArrivalUnary, arrivals);
}

void Cutter::exclude_others(const cv::Mat& surveyed) {
  if (cv::countNonZero((background_.changed > 0.5) & ~inside_) >= kFewestPixels) {
    exclude_moved_neighbours();
    exclude_intruders(reaching_border(surveyed(window_))(crop_ - window_.tl()));
  }
  exclude(change::find_arrivals(before_, after_, map_, platform_));
}

void Cutter::exclude_moved_neighbours() {
  const cv::Mat changed = background_.changed > 0.5;
  const cv::Mat moved = change::moved_neighbours(before_, after_, changed, noise_.sigma(1));
  map_.setTo(0, moved);
  background_.changed.setTo(0, moved);
  background_.log_ratio.setTo(kArrivalUnary, moved);
}

void Cutter::exclude_intruders(const cv::Mat& from_afar) {
  const cv::Mat changed = background_.changed > 0.5;
  intruders_ =
      find_intruders(before_, after_, changed, changed & ~inside_ & from_afar, platform_, noise_);
  if (cv::countNonZero(intruders_) == 0) return;
  map_.setTo(0, intruders_);
  remove_specks(map_, kSpeck);
  cv::Mat rim;
  cv::dilate(intruders_, rim, cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5}));
  intruders_ |= rim & ~map_;
  background_.changed.setTo(0, intruders_);
  cv::Mat platform;
  cv::log(likelihood::relative_density(platform_, before_) + 1e-3, platform);
  platform = cv::min(platform + kCovered, kArrivalUnary);
  platform.copyTo(background_.log_ratio, intruders_);
}

cv::Mat Cutter::clipped(const cv::Mat& unary) {
  return cv::max(cv::min(unary, kViewLogOdds), -kViewLogOdds);
}

cv::Mat Cutter::confirmed() const {
  if (include_.empty()) return {};
  cv::Mat confirmed;
  cv::dilate(include_ | exclude_, confirmed, cv::Mat::ones(kCheckedBox, kCheckedBox, CV_8U));
  return confirmed;
}

cv::Mat Cutter::own_colours() const {
  const cv::Mat own = map_ & ~coloured_shadow_;
  return cv::countNonZero(own) < kLeastOwn * cv::countNonZero(map_) ? map_ : own;
}

cv::Mat Cutter::preference() const {
  const change::ColourMixture object = change::ColourMixture::fit(
      before_, own_colours(), likelihood::colour_weights(background_.changed, map_));
  cv::Mat unary = likelihood::object_preference(before_, object, background_.log_ratio,
                                                coarse_.empty() ? cv::Mat() : map_);
  if (!other_view_.empty()) unary = clipped(unary) + other_view_;
  return unary;
}

cv::Rect crop_of(const cv::Rect& region, const cv::Size& image) {
  const int margin = std::max(6, std::max(region.width, region.height) / 20);
  return imaging::grown(region, margin) & cv::Rect({0, 0}, image);
}

ObjectCut iterated_cut(const std::shared_ptr<Cutter>& cutter, const cv::Size& size, int iterations,
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

ObjectCut empty_cut(const cv::Size& size) {
  CutEvidence evidence;
  evidence.region_span = 0;
  return {cv::Mat::zeros(size, CV_8UC1), evidence, {}, {}, {}};
}

}  // namespace mbncc::segmentation
