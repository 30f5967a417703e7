// SPDX-License-Identifier: BSD-3-Clause
// Writes the evaluation as an HTML page with the images that contain errors.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "cli/evaluate/evaluation.hpp"

namespace mbncc::cli {

class EvaluationPage {
 public:
  /// With "" nothing is written. `inputs` are not replaced. Throws FileError.
  EvaluationPage(std::string folder, std::vector<std::string> inputs);

  /// Adds an image with a missed instance or a wrong detection.
  void add(const std::string& image_path, const cv::Mat& image, const Comparison& comparison);

  /// Writes index.html and returns its path; "" if nothing is written.
  std::string finish(const Figures& figures) const;

 private:
  std::string folder_;
  std::vector<std::string> inputs_;
  std::string rows_;
  int images_ = 0;
};

/// One sentence per figure.
std::vector<std::string> sentences_of(const Figures& figures);

}  // namespace mbncc::cli
