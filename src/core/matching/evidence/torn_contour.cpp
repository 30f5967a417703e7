// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/torn_contour.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace mbncc::evidence {
namespace {

constexpr int kTurns = 4;       // rotation steps to each side, ...
constexpr double kArc = 1.5;    // [px] ... by which the rim moves
constexpr int kShifts = 5;      // shifts along x to each side, ...
constexpr double kShift = 1.5;  // [px] ... of this size, small enough not to skip an edge
constexpr int kApart = 3;       // least shifts between the parts; fewer are an intact outline
constexpr double kSlack = 24;   // [px] more than the motion of any point

class TornOutline {
 public:
  TornOutline(const templates::ContourTemplate& contour, const scene::SceneLevel& scene,
              const Pose2D& pose, double scale)
      : contour_(contour),
        pixels_(scene.around(pose, scale * contour.radius() + kSlack)),
        pose_(pose),
        scale_(scale),
        order_(contour.size()) {
    const double c = std::cos(pose.theta), s = std::sin(pose.theta);
    std::iota(order_.begin(), order_.end(), 0);
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return s * contour.x[a] + c * contour.y[a] < s * contour.x[b] + c * contour.y[b];
    });
  }

  double advantage() {
    double whole = -1, torn = -1;
    for (int turn = -kTurns; turn <= kTurns; ++turn) {
      for (int shift = -kShifts; shift <= kShifts; ++shift) read(turn, shift);
      if (std::abs(turn) <= 1)
        for (int shift = -1; shift <= 1; ++shift)
          whole = std::max<double>(whole, responses_[kShifts + shift].back() / visible_);
      torn = std::max(torn, best_torn());
    }
    return torn - whole;
  }

 private:
  using Sums = std::vector<float>;  // cumulative responses of the points, from the top

  void read(int turn, int shift) {
    const double angle = turn * kArc / std::max(1.0, scale_ * contour_.radius());
    const Pose2D pose{pose_.x + shift * kShift, pose_.y, pose_.theta + angle};
    templates::read_contour(contour_, pixels_.edges, pose, 0, sample_, scale_);
    Sums& sums = responses_[kShifts + shift];
    sums.assign(1, 0);
    for (const std::size_t i : order_) sums.push_back(sums.back() + sample_.response[i]);
    if (shift == 0)
      visible_ = std::max(1.F, std::accumulate(sample_.seen.begin(), sample_.seen.end(), 0.F));
  }

  /// Best mean response of a torn outline at the rotation last read. Each part has at least a
  /// quarter of the outline.
  double best_torn() const {
    float best = 0;
    const std::size_t points = order_.size();
    for (std::size_t i = points / 4; i <= 3 * points / 4; ++i) best = std::max(best, torn_at(i));
    return best / visible_;
  }

  /// Best sum of responses if the upper part, the points before `i`, and the lower part, the
  /// others, are at least kApart shifts from each other.
  float torn_at(std::size_t i) const {
    const auto upper = [&](std::size_t shift) { return responses_[shift][i]; };
    const auto lower = [&](std::size_t shift) {
      return responses_[shift].back() - responses_[shift][i];
    };
    constexpr float kNone = -1e6F;
    float best = kNone, best_upper = kNone, best_lower = kNone;  // kApart or more behind
    for (std::size_t shift = kApart; shift < responses_.size(); ++shift) {
      best_upper = std::max(best_upper, upper(shift - kApart));
      best_lower = std::max(best_lower, lower(shift - kApart));
      best = std::max({best, best_upper + lower(shift), best_lower + upper(shift)});
    }
    return best;
  }

  const templates::ContourTemplate& contour_;
  scene::PreparedPixels pixels_;
  Pose2D pose_;
  double scale_;
  std::vector<std::size_t> order_;  // of the points, from the image's top down
  templates::ContourSample sample_;
  std::array<Sums, 2 * kShifts + 1> responses_;
  float visible_ = 1;
};

}  // namespace

double advantage_torn(const templates::ContourTemplate& contour, const scene::SceneLevel& scene,
                      const Pose2D& pose, double scale) {
  return TornOutline(contour, scene, pose, scale).advantage();
}

}  // namespace mbncc::evidence
