// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/search_roi.hpp"

#include <cstdio>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {

cv::Rect parse_roi(const std::string& text) {
  if (text.empty()) return {};
  cv::Rect roi;
  int read = 0;
  const int fields = std::sscanf(text.c_str(), "%6d,%6d,%6d,%6d%n", &roi.x, &roi.y, &roi.width,
                                 &roi.height, &read);
  const bool complete = fields == 4 && read == static_cast<int>(text.size());
  if (!complete || roi.x < 0 || roi.y < 0 || roi.width < 1 || roi.height < 1)
    throw ConfigError("parameter 'search_roi': value '" + text +
                      "' is not allowed; give x,y,width,height in pixels, or nothing");
  return roi;
}

cv::Rect roi_in(const cv::Rect& roi, cv::Size image) {
  if (roi.empty()) return roi;
  const cv::Rect inside = roi & cv::Rect({}, image);
  if (inside.empty())
    throw ConfigError("parameter 'search_roi' lies outside the image of " +
                      std::to_string(image.width) + " x " + std::to_string(image.height) +
                      "; give one that overlaps it, or nothing");
  return inside;
}

}  // namespace mbncc::nodelets
