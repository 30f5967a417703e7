// SPDX-License-Identifier: BSD-3-Clause
// A typical solution with OpenCV: rotated templates with masks, cv::matchTemplate, three pyramid
// levels.
#pragma once

#include <vector>

#include "matching/engine.hpp"

namespace mbncc::bench {

class MaskedTemplateEngine : public Engine {
 public:
  void teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) override;
  std::vector<Found> find(const cv::Mat& image) override;

 private:
  /// Template and mask centred on the excircle, at one pyramid level and rotation.
  struct Rotated {
    cv::Mat template_image, mask;
    double theta;
  };
  /// A candidate position of the excircle's centre at some level, with a rotation.
  struct Peak {
    cv::Point2d position;
    double theta;
    double score;
  };

  Rotated rotated(int level, double theta) const;
  double angle_step(int level) const;
  std::vector<Peak> coarse_peaks(const cv::Mat& image) const;
  Peak refined(const cv::Mat& image, int level, const Peak& peak) const;

  cv::Mat template_, mask_;  // CV_8UC1 crops around the excircle, full resolution
  double radius_ = 0;        // [px] of the excircle
  cv::Point2d lever_;        // reference point relative to the excircle's centre
  int coarse_level_ = 0;
  std::vector<Rotated> coarse_;
};

}  // namespace mbncc::bench
