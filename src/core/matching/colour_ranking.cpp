#include "matching/colour_ranking.hpp"

#include <algorithm>
#include <cstdint>

namespace mbncc {
namespace {

constexpr double kWeight = 0.2;  // of a log-odds by colour, against a mean response

/// What the colours of a picture say for an object.
class ColourVoice {
 public:
  ColourVoice(const PreparedView& view, const ScenePicture& scene, int level)
      : classes_(scene.classes().at(view.gate.level())),
        speaking_(view.gate.speaking(scene.classes())),
        points_(view.rough[level].surface),
        to_class_(static_cast<float>(1 << level) / static_cast<float>(1 << view.gate.level())) {}

  /// Mean log-odds of the colours under `pose` [px at the poses' level].
  double mean(const Pose2D& pose) const {
    constexpr std::size_t kStep = 3;  // every third point tells enough
    const Transform moved(pose);
    int sum = 0, count = 0;
    for (std::size_t i = 0; i < points_.size(); i += kStep, ++count) {
      const cv::Point2d at = moved({points_.x[i], points_.y[i]}) * to_class_;
      const int x = std::clamp(static_cast<int>(at.x), 0, classes_.cols - 1);
      const int y = std::clamp(static_cast<int>(at.y), 0, classes_.rows - 1);
      sum += speaking_[classes_.at<std::uint16_t>(y, x)];
    }
    return count == 0 ? 0 : static_cast<double>(sum) / (count * ColourGate::kUnit);
  }

 private:
  const cv::Mat& classes_;
  ColourGate::Speaking speaking_;
  const SurfaceTemplate& points_;
  float to_class_;
};

}  // namespace

std::vector<Candidate> best_by_colours(const PreparedView& view, const ScenePicture& scene,
                                       std::vector<Candidate> poses, std::size_t most) {
  if (!poses.empty() && scene.classes().last_level() >= view.gate.level()) {
    const ColourVoice voice(view, scene, poses.front().level);
    for (auto& candidate : poses) candidate.value += kWeight * voice.mean(candidate.pose);
  }
  const auto end = poses.begin() + static_cast<std::ptrdiff_t>(std::min(most, poses.size()));
  std::partial_sort(poses.begin(), end, poses.end(),
                    [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
  poses.erase(end, poses.end());
  return poses;
}

}  // namespace mbncc
