// SPDX-License-Identifier: BSD-3-Clause
// The steps that change_cut() and region_cut() share: from a pair of aligned images to the map.
#pragma once

#include <memory>
#include <opencv2/core.hpp>

#include "learning/alignment/align_images.hpp"
#include "learning/change/colour_mixture.hpp"
#include "learning/likelihood/background_likelihood.hpp"
#include "learning/likelihood/noise_model.hpp"
#include "learning/segmentation/smoothness.hpp"
#include "mbncc/learning/object_cut.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc::segmentation {

// One cut. All images have the crop's size and own their memory, because the pair's
// images are much larger and a cut lives as long as its lesson.
class Cutter {
 public:
  Cutter(const alignment::AlignedPair& pair, const cv::Rect& crop, const cv::Rect& region);

  // First of the steps: how well each pixel is explained as platform. `darkest_shadow` is the least
  // light that a shadow leaves.
  void explain_background(float darkest_shadow = likelihood::kDarkestShadow);

  // Finds the changed pixels from which the object's colours are first learned; false if there are
  // too few. `surveyed` is ChangeSurvey::changed of the whole image; it is empty without an image
  // after, because nothing can have moved or arrived.
  bool seed(const cv::Mat& surveyed);

  void weigh_edges();

  // One graph cut with colours learned from the map so far.
  void cut();

  // Cuts again with local colours along the rim, because blur, demosaicing and compression spread
  // the change beyond the outline.
  void cut_rim();

  void clean();

  // A further cut with painted pixels as hard constraints; pixels that resemble excluded ones are
  // removed as well. Smoothness does not extend a stroke to its neighbours, because a thin part may
  // be next to a gap.
  Cutter painted(const cv::Mat& include, const cv::Mat& exclude) const;

  // A further cut that includes the evidence of another view.
  Cutter informed(const cv::Mat& preference) const;

  cv::Mat full_size_map(const cv::Size& size) const;
  cv::Mat full_size_preference(const cv::Size& size) const;
  CutEvidence evidence() const;

 private:
  // half_ must be `smoothness` at half resolution.
  void cut_by_unary(const Smoothness& smoothness);

  // Arrivals exist only in the image after: their place in the image before is platform.
  void exclude(cv::Mat arrivals);
  void exclude_others(const cv::Mat& surveyed);

  // Called, like exclude_intruders(), only if the change extends beyond the region, because the
  // object lies inside it.
  void exclude_moved_neighbours();

  // Pixels that an intruder covers afterwards can be classified only by their colour before.
  void exclude_intruders(const cv::Mat& from_afar);

  // Clipped log-odds of one view in a cut of both, so that no pixel dominates the other view.
  static cv::Mat clipped(const cv::Mat& unary);

  // Pixels near the strokes were checked by the operator as well.
  cv::Mat confirmed() const;

  // The part of the map that the object's colours are learned from: without shadows, unless most of
  // it has the shadowed platform's colour, because the object itself may have it.
  cv::Mat own_colours() const;

  // Log-odds of the object, whose colours are learned from the current map; outside the region as
  // well.
  cv::Mat preference() const;

  cv::Rect window_;  // of the aligned pair
  cv::Rect crop_;
  cv::Mat before_, after_, inside_;
  likelihood::NoiseModel noise_;
  change::ColourMixture platform_;
  likelihood::BackgroundLikelihood background_;
  cv::Mat coloured_shadow_;              // CV_8UC1
  bool verified_, shadow_like_ = false;  // see CutEvidence
  Smoothness smoothness_, half_;         // half_: at half resolution
  cv::Mat unary_, coarse_, map_;
  cv::Mat object_like_;        // see FinishedCut
  cv::Mat intruders_;          // empty, or of the crop's size
  cv::Mat other_view_;         // empty, or of the crop's size
  cv::Mat include_, exclude_;  // both empty, or both of the crop's size
  cv::Mat kept_;               // CV_8UC1 or empty: groups that lie there belong to the object
};

/// The part of the images (of size `image`) that a cut in `region` looks at.
cv::Rect crop_of(const cv::Rect& region, const cv::Size& image);

/// Cuts a seeded `cutter` `iterations` times. The result has the images' `size`.
ObjectCut iterated_cut(const std::shared_ptr<Cutter>& cutter, const cv::Size& size, int iterations,
                       const BeforeCut& before_cut);

/// The result if nothing in the region changed.
ObjectCut empty_cut(const cv::Size& size);

}  // namespace mbncc::segmentation
