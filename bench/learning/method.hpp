// SPDX-License-Identifier: BSD-3-Clause
// Methods of segmenting an object in its image, behind one interface.
#pragma once

#include <functional>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "common/case_folder.hpp"

namespace mbncc::bench {

struct Cut {
  cv::Mat map;           ///< CV_8UC1 of the image's size; empty if the lesson was refused
  double map_ms = 0;     ///< thread CPU time from images to map
  double lesson_ms = 0;  ///< thread CPU time of the whole lesson, verdict included; NaN: no lesson
  std::string outcome;   ///< "GOOD", "MARGINAL", "BAD", or the name of the error
};

struct Method {
  std::string name;
  std::function<Cut(const CaseFolder& one, int iterations)> cut;
};

/// The package's methods (sb_grabcut with the superpixels that suit it best), and GrabCut with
/// scribbles like those of the paper's operator.
std::vector<std::string> usual_methods();

/// One of usual_methods(), another method of LearningConfig, or sb_grabcut with other superpixels,
/// such as "sb_grabcut_slic_4000".
Method method_named(const std::string& name);

}  // namespace mbncc::bench
