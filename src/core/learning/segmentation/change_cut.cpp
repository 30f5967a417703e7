// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/change_cut.hpp"

#include <algorithm>
#include <array>
#include <memory>

#include "learning/alignment/align_images.hpp"
#include "learning/likelihood/background_likelihood.hpp"
#include "learning/segmentation/cutter.hpp"

namespace mbncc {
namespace {

// Least light [0..1] that a shadow leaves. A grey object looks like shadowed platform; but an
// object was taken away, so while shadows explain the whole change, the next higher limit is tried.
constexpr std::array<float, 4> kDarkestShadows{likelihood::kDarkestShadow, 0.5F, 0.7F, 0.9F};

}  // namespace

ObjectCut change_cut(const cv::Mat& before, const cv::Mat& after, const cv::Rect& region,
                     const cv::Mat& changed, int iterations, int max_shift,
                     const BeforeCut& before_cut) {
  const auto cutter = std::make_shared<segmentation::Cutter>(
      alignment::align_images(before, after, region, changed, max_shift),
      segmentation::crop_of(region, before.size()), region);
  const auto leaves_an_object = [&](float darkest_shadow) {
    cutter->explain_background(darkest_shadow);
    return cutter->seed(changed);
  };
  if (std::none_of(kDarkestShadows.begin(), kDarkestShadows.end(), leaves_an_object))
    return segmentation::empty_cut(before.size());
  return segmentation::iterated_cut(cutter, before.size(), iterations, before_cut);
}

}  // namespace mbncc
