#include "matching/mixture.hpp"

#include <algorithm>
#include <cmath>

#include "matching/picture_view.hpp"

namespace mbncc {
namespace {

constexpr float kPure = 0.98f;        // share from which on nothing is taken out
constexpr float kLeast = 0.3f;        // share: noise grows with its inverse
constexpr float kBackground = 0.12f;  // share of the object in what counts as background
constexpr float kNowhere = -1e6f;     // lies outside of every picture

/// Blur [px, level 0] that a map's edge has in a level: lens, pixels, smoothing.
double blur_of(int level) {
  constexpr double kLens = 0.8;
  const double smoothing = (level == 0 ? 0.9 : 0.67) * (1 << level);
  return std::hypot(kLens, smoothing);
}

}  // namespace

Coverage::Coverage(const MapGeometry& map, int level)
    : side_(1 << level),
      room_(static_cast<int>(std::ceil(3 * blur_of(level)))),
      share_(map.blurred(blur_of(level), room_)) {}

Mixture Coverage::at(cv::Point pixel) const {
  const cv::Point middle = pixel + cv::Point(room_, room_);
  const cv::Rect picture({0, 0}, share_.size());
  const int reach = 4 * side_ + 3, step = std::max(1, side_ / 2);
  Mixture mixture;
  std::array<double, 2> nearest{1e9, 1e9};
  std::array<cv::Point, 2> offsets;
  for (int k = 0; k < 2; ++k)
    for (int y = -reach; y <= reach; y += step)
      for (int x = -reach; x <= reach; x += step) {
        const cv::Point offset(x, y);
        const double distance = cv::norm(offset);
        if (distance >= nearest[k] || !picture.contains(middle + offset)) continue;
        if (share_.at<float>(middle + offset) > kBackground) continue;
        if (k == 1 && offset.dot(offsets[0]) > -0.3 * distance * nearest[0]) continue;
        nearest[k] = distance;
        offsets[k] = offset;
      }
  if (nearest[0] > reach * 2) return mixture;
  if (nearest[1] > nearest[0] + 2 * side_) offsets[1] = offsets[0];
  mixture.share = std::min(share_.at<float>(middle), 1.f);
  for (int k = 0; k < 2; ++k) mixture.beyond[k] = cv::Point2f(pixel + offsets[k]);
  return mixture;
}

Unmixing::Unmixing(const std::vector<Mixture>& mixtures, cv::Point2d origin, std::size_t padded)
    : share_(padded, 1.f) {
  for (int k = 0; k < 2; ++k) {
    x_[k].assign(padded, kNowhere);
    y_[k].assign(padded, kNowhere);
  }
  for (std::size_t i = 0; i < mixtures.size(); ++i) {
    share_[i] = std::max(kLeast, mixtures[i].share);
    for (int k = 0; k < 2; ++k) {
      x_[k][i] = static_cast<float>(mixtures[i].beyond[k].x - origin.x);
      y_[k][i] = static_cast<float>(mixtures[i].beyond[k].y - origin.y);
    }
  }
}

void Unmixing::resize(double factor) {
  for (auto* places : {&x_[0], &x_[1], &y_[0], &y_[1]})
    for (auto& place : *places) place *= static_cast<float>(factor);
}

void Unmixing::apply(const SceneLevel& scene, const Pose2D& pose, double scale,
                     const std::vector<float>& inside,
                     std::array<std::vector<float>, 3>& planes) const {
  constexpr int kSeen = 3;  // after the three channels
  using Colours = std::array<std::vector<float>, 4>;
  thread_local std::array<Colours, 2> beyond;
  for (int k = 0; k < 2; ++k) {
    Colours& read = beyond[k];
    for (auto& values : read) values.resize(share_.size());
    kernels::sample_colours(view_of(scene.colour),
                            {x_[k].data(), y_[k].data(), static_cast<int>(share_.size())},
                            placement_of(pose, scale),
                            {read[0].data(), read[1].data(), read[2].data(), read[kSeen].data()});
  }
  for (std::size_t i = 0; i < share_.size(); ++i) {
    const float seen = beyond[0][kSeen][i] + beyond[1][kSeen][i];
    if (seen == 0 || inside[i] == 0 || share_[i] > kPure) continue;
    for (std::size_t c = 0; c < planes.size(); ++c) {
      const float background = (beyond[0][c][i] + beyond[1][c][i]) / seen;
      float& value = planes[c][i];
      value = std::clamp((value - (1 - share_[i]) * background) / share_[i], 0.f, 255.f);
    }
  }
}

}  // namespace mbncc
