// SPDX-License-Identifier: BSD-3-Clause
// Settings of learn_object.
#pragma once

#include <string>

#include "mbncc/config/field.hpp"

namespace mbncc {

struct LearningConfig {
  std::string method = "auto";  ///< one of the choices below; run by teaching/segmenter.cpp
  int iterations = 2;           ///< number of graph cuts in every method
  std::string superpixel_method = "seeds";  ///< of sb_grabcut: seeds or slic
  int superpixels = 1600;   ///< sb_grabcut: superpixels requested in the region's crop
  double min_area = 80;     ///< [px] smaller maps are refused
  double max_change = 0.4;  ///< [0..1] changed part of the image above which a lesson must show
                            ///< the object's place
  double max_exposure_change =
      1.41;  ///< factor between the images above which a lesson must show the object's place
  double max_light_change = 1.15;  ///< the same between the quarters of the image
  int max_shift = 8;  ///< [px] largest camera shift between before and after that is compensated

  template <class Self, class Visitor>
  static void fields(Self& self, Visitor&& visit) {
    visit(
        FieldInfo{"method",
                  Allowed::one_of({"auto", "change_cut", "region_cut", "sb_grabcut", "grabcut_rect",
                                   "grabcut_mask"}),
                  "",
                  "segmentation; auto: change_cut with an after image (grabcut_mask where that is "
                  "clearer at the region's edge), else the clearer of region_cut and "
                  "grabcut_rect"},
        self.method);
    visit(FieldInfo{"iterations", Allowed::range(1, 20), "", "graph cuts of every method"},
          self.iterations);
    visit(FieldInfo{"superpixel_method", Allowed::one_of({"seeds", "slic"}), "",
                    "superpixels of sb_grabcut"},
          self.superpixel_method);
    visit(FieldInfo{"superpixels", Allowed::range(16, 100000), "",
                    "superpixels requested by sb_grabcut in the region's crop"},
          self.superpixels);
    visit(FieldInfo{"min_area", Allowed::range(1, 1e6), "px", "smaller maps are refused"},
          self.min_area);
    visit(FieldInfo{"max_change", Allowed::range(0.05, 1), "",
                    "changed part of the image above which a lesson must show the object's place"},
          self.max_change);
    visit(
        FieldInfo{"max_exposure_change", Allowed::range(1.05, 10), "",
                  "exposure factor between the images above which a lesson must show the object's "
                  "place"},
        self.max_exposure_change);
    visit(FieldInfo{"max_light_change", Allowed::range(1.05, 10), "",
                    "the same between quarters of the image"},
          self.max_light_change);
    visit(FieldInfo{"max_shift", Allowed::range(0, 64), "px",
                    "largest camera shift between before and after that is compensated"},
          self.max_shift);
  }
};

}  // namespace mbncc
