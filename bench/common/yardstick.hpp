// SPDX-License-Identifier: BSD-3-Clause
// Reference workloads by which times are divided, so that results from different machines are
// comparable.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc::bench {

/// One unrotated cv::matchTemplate (TM_CCOEFF_NORMED) of 101 x 101 in 640 x 480 pixels of noise.
class MatchYardstick {
 public:
  MatchYardstick();
  void run();

 private:
  cv::Mat image_, template_, scores_;
};

/// One cv::grabCut with a rectangle, two iterations, on 200 x 200 pixels of smoothed noise.
class CutYardstick {
 public:
  CutYardstick();
  void run();

 private:
  cv::Mat image_, labels_, background_, foreground_;
};

}  // namespace mbncc::bench
