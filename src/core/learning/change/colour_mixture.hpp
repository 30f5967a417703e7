// SPDX-License-Identifier: BSD-3-Clause
// Gaussian mixture of colours.
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace mbncc::change {

class ColourMixture {
 public:
  /// Fits up to five Gaussians to the pixels of `image` (CV_32FC3) on `mask` (CV_8UC1), weighted by
  /// `weight` (CV_32FC1; empty: all 1); at most about 6000 of them. The start is deterministic: the
  /// widest cluster is split along its main axis. With fewer than 20 pixels, the mixture is empty.
  static ColourMixture fit(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& weight = {});

  bool empty() const { return components_.empty(); }

  /// Density of a colour. [1 / grey level^3]
  float density(const cv::Vec3f& colour) const;

  /// Density of each pixel of a CV_32FC3 image, CV_32FC1.
  cv::Mat densities(const cv::Mat& image) const;

 private:
  struct Component {
    cv::Vec3f mean;
    cv::Matx33f precision;
    float log_weight = 0;  // log of the weight and the Gaussian's constant

    float log_density(float blue, float green, float red) const;
    float log_density(const cv::Vec3f& colour) const;
  };

  friend class MixtureFit;
  std::vector<Component> components_;
};

}  // namespace mbncc::change
