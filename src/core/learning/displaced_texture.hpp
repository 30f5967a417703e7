// Whether a camera moved between two pictures, told by texture.
#pragma once

#include <opencv2/core.hpp>

namespace mbncc {

/// Part of the textured squares [0..1] that show something else in the other picture (both
/// CV_32FC1, grey, of one size). Light and exposure leave the correlation of small squares alone; a
/// moved camera does not. It displaces the texture of both pictures, so the smaller of both parts
/// counts: of a scene that many things left, the rest stays.
double displaced_part(const cv::Mat& before, const cv::Mat& after);

}  // namespace mbncc
