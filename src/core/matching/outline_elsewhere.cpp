#include "matching/outline_elsewhere.hpp"

#include <algorithm>
#include <cmath>

namespace mbncc {
namespace {

constexpr double kNearest = 2.9;  // [px] what is nearer is the same place, not known that well

class OutlineShift {
 public:
  OutlineShift(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
               double scale)
      : contour_(contour),
        scene_(scene),
        pose_(pose),
        scale_(scale),
        radius_(std::max(1.0, scale * contour.radius())) {
    constexpr double kSlack = 20;  // [px] more than the way to the farthest place
    scene.prepare_around(pose, radius_ + kSlack);
  }

  double gain() {
    constexpr double kStep = 2;     // [px] an edge in between is still seen
    constexpr int kFarthest = 3;    // steps along x and y
    constexpr double kWorse = 0.1;  // agreement that the last pixel does not make up for
    const double here = agreement({});
    double best = -1;
    for (int i = -kFarthest; i <= kFarthest; ++i)
      for (int j = -kFarthest; j <= kFarthest; ++j) {
        const cv::Vec3d shift(kStep * i, kStep * j, 0);
        if (is_near(shift)) continue;
        const double there = agreement(shift);
        best = std::max(best, there > here - kWorse ? climbed(shift, there) : there);
      }
    return best - here;
  }

 private:
  static bool is_near(const cv::Vec3d& shift) { return std::hypot(shift[0], shift[1]) < kNearest; }

  /// Where the contour is moved by x, y, and along its rim [px].
  double agreement(const cv::Vec3d& shift) {
    const Pose2D at{pose_.x + shift[0], pose_.y + shift[1], pose_.theta + shift[2] / radius_};
    read_contour(contour_, scene_.edges, at, 1, sample_, scale_);
    return contour_agreement(contour_, sample_);
  }

  /// The most that steps of a pixel reach from a place of this agreement.
  double climbed(cv::Vec3d shift, double agreed) {
    constexpr int kSteps = 4;
    for (int k = 0; k < kSteps; ++k) {
      const cv::Vec3d start = shift;
      for (int direction = 0; direction < 6; ++direction) {
        cv::Vec3d next = start;
        next[direction / 2] += direction % 2 == 0 ? 1 : -1;
        const double there = is_near(next) ? -1 : agreement(next);
        if (there <= agreed) continue;
        agreed = there;
        shift = next;
      }
      if (shift == start) break;
    }
    return agreed;
  }

  const ContourTemplate& contour_;
  const SceneLevel& scene_;
  Pose2D pose_;
  double scale_, radius_;
  ContourSample sample_;
};

}  // namespace

double better_elsewhere(const ContourTemplate& contour, const SceneLevel& scene, const Pose2D& pose,
                        double scale) {
  return OutlineShift(contour, scene, pose, scale).gain();
}

}  // namespace mbncc
