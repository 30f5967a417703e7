// SPDX-License-Identifier: BSD-3-Clause
// Writes searched images with the matches drawn into them.
#pragma once

#include <opencv2/core.hpp>
#include <set>
#include <string>
#include <vector>

#include "mbncc/matching/matcher.hpp"

namespace mbncc::cli {

class OverlayWriter {
 public:
  /// Creates the folder; with "" nothing is written. `inputs` are not replaced.
  OverlayWriter(std::string folder, std::vector<std::string> inputs);

  /// Writes `folder/<image>_overlay.png`, numbered if several images have the same file name.
  void write(const std::string& image_path, const cv::Mat& image,
             const std::vector<Match>& matches);

  /// Reports on stderr what was written.
  void tell() const;

 private:
  std::string folder_;
  std::vector<std::string> inputs_;
  std::set<std::string> written_;
};

}  // namespace mbncc::cli
