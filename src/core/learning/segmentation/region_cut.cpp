// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/region_cut.hpp"

#include <memory>

#include "learning/likelihood/predicted_platform.hpp"
#include "learning/segmentation/cutter.hpp"

namespace mbncc {

ObjectCut region_cut(const cv::Mat& before, const cv::Rect& region, int iterations,
                     const BeforeCut& before_cut) {
  const auto cutter =
      std::make_shared<segmentation::Cutter>(likelihood::predict_platform(before, region),
                                             segmentation::crop_of(region, before.size()), region);
  cutter->explain_background();
  if (!cutter->seed(cv::Mat())) return segmentation::empty_cut(before.size());
  return segmentation::iterated_cut(cutter, before.size(), iterations, before_cut);
}

}  // namespace mbncc
