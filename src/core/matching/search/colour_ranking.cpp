// SPDX-License-Identifier: BSD-3-Clause
#include "matching/search/colour_ranking.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace mbncc::search {
namespace {

constexpr double kWeight = 0.2;  // weight of a colour log-odds relative to a mean response

/// Colour log-likelihood of an object in an image.
class ColourLikelihood {
 public:
  ColourLikelihood(const prepared::PreparedView& view, const scene::SceneImage& scene, int level)
      : classes_(scene.classes().at(view.colour_prefilter.level())),
        ratios_(view.colour_prefilter.log_likelihood_ratios(scene.classes())),
        to_class_(static_cast<float>(1 << level) /
                  static_cast<float>(1 << view.colour_prefilter.level())) {
    constexpr std::size_t kStep = 3;  // every third point suffices
    const templates::SurfaceTemplate& surface = view.rough[level].surface;
    for (std::size_t i = 0; i < surface.size(); i += kStep)
      points_.push_back(to_class_ * cv::Point2f(surface.x[i], surface.y[i]));
  }

  /// Mean log-odds of the colours under `pose` [px at the poses' level].
  double mean(const Pose2D& pose) const {
    if (points_.empty()) return 0;
    const auto theta = static_cast<float>(pose.theta);
    const float cosine = std::cos(theta), sine = std::sin(theta);
    const cv::Point2f middle = to_class_ * cv::Point2f(pose.position());
    int sum = 0;
    for (const auto& point : points_) {
      const float x = cosine * point.x - sine * point.y + middle.x;
      const float y = sine * point.x + cosine * point.y + middle.y;
      const int column = std::clamp(static_cast<int>(x), 0, classes_.cols - 1);
      const int row = std::clamp(static_cast<int>(y), 0, classes_.rows - 1);
      sum += ratios_[classes_.at<std::uint16_t>(row, column)];
    }
    return static_cast<double>(sum) /
           (static_cast<double>(points_.size()) * proposal::ColourPrefilter::kUnit);
  }

 private:
  const cv::Mat& classes_;
  proposal::ColourPrefilter::LogLikelihoodRatios ratios_;
  float to_class_;                   // from the poses' level
  std::vector<cv::Point2f> points_;  // [px at the classes' level]
};

}  // namespace

std::vector<templates::Candidate> ranked_by_colours(const prepared::PreparedView& view,
                                                    const scene::SceneImage& scene,
                                                    std::vector<templates::Candidate> poses) {
  if (!poses.empty() && scene.classes().last_level() >= view.colour_prefilter.level()) {
    const ColourLikelihood likelihood(view, scene, poses.front().level);
    for (auto& candidate : poses) candidate.value += kWeight * likelihood.mean(candidate.pose);
  }
  templates::sort_by_value(poses);
  return poses;
}

}  // namespace mbncc::search
