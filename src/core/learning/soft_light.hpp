// Shadows end softly, objects sharply.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// 255 where it is darker than afterwards and unchanged platform is reached through light that
/// changes gradually: what lies there is platform in a shadow. `before` and `after` are CV_32FC3,
/// aligned; `changed` (CV_32FC1) is the probability that a pixel shows something else, `sigma` the
/// deviation of the noise [grey levels].
cv::Mat soft_shadow(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                    float sigma);

}  // namespace mbncc
