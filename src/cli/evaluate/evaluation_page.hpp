// SPDX-License-Identifier: BSD-3-Clause
// The evaluation as a page with the images of errors.
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "cli/evaluate/evaluation.hpp"

namespace mbncc::cli {

class EvaluationPage {
 public:
  /// "": none is written. Throws FileError.
  explicit EvaluationPage(std::string folder);

  /// Adds an image with a miss or a wrong detection.
  void add(const std::string& image_path, const cv::Mat& image, const Comparison& comparison);

  /// Writes index.html; returns its path, "" for none.
  std::string finish(const Figures& figures) const;

 private:
  std::string folder_;
  std::string rows_;
  int images_ = 0;
};

/// One sentence per figure.
std::vector<std::string> sentences_of(const Figures& figures);

}  // namespace mbncc::cli
