#include <algorithm>
#include <array>
#include <cmath>

#include "matching/padded_vectors.hpp"
#include "matching/picture_view.hpp"
#include "matching/rendering.hpp"

namespace mbncc {
namespace {

constexpr int kLight = Rendering::kLight, kMotion = 3, kUnknowns = kLight + kMotion;
constexpr int kSeen = kUnknowns, kRows = kUnknowns + 1;

/// What is seen at a pose.
struct Reading {
  std::vector<float> values;  // per axis of colour and point, without the background's share
  std::vector<float> inside;  // per point
};

/// Gauss-Newton in light and motion together; values that fit badly count less, and those along an
/// axis of colour where the others fit badly, too.
class RenderingFit {
 public:
  RenderingFit(const Rendering& object, const SceneLevel& scene) : object_(object), scene_(scene) {
    const std::size_t count = Rendering::kChannels * object.padded();
    rows_.assign(kRows * count, 0.f);
    std::copy(object.light.begin(), object.light.end(), rows_.begin());
    weights_.assign(count, 1.f);
    residual_.resize(count);
    inside_.resize(count);
  }

  Rendered run(const Pose2D& start) {
    scene_.prepare_around(start, object_.reach + kFar);
    return described(settled(start));
  }

 private:
  static constexpr double kFar = 4;  // [px] from the start

  std::size_t count() const { return residual_.size(); }
  float* row(int k) { return &rows_[k * count()]; }

  Pose2D settled(const Pose2D& start) {
    constexpr int kIterations = 8;
    Pose2D pose = start, best = start;
    double least = 0;
    for (int k = 0; k <= kIterations && look_at(pose); ++k) {
      const double cost = k == 0 ? first_cost() : weigh();
      if (k == 0 || cost < least) {
        least = cost;
        best = pose;
      }
      const cv::Vec3d step = next_step(pose);
      pose = {pose.x + step[0], pose.y + step[1], pose.theta + step[2] / object_.radius};
      if (cv::norm(step) < 0.02 || cv::norm(pose.position() - start.position()) > kFar) break;
    }
    return best;
  }

  /// What is seen at a pose.
  Rendered described(const Pose2D& pose) {
    constexpr int kSettling = 2;  // times that the weights and the light adapt to each other
    Rendered rendered{pose};
    if (!look_at(pose)) return rendered;
    weights_.assign(count(), 1.f);
    first_cost();
    for (int k = 0; k < kSettling; ++k) weigh();
    rendered.misfit = misfit();
    rendered.brightness = brightness();
    return rendered;
  }

  double misfit() const;
  double brightness();

  /// False when too little is visible.
  bool look_at(const Pose2D& pose) {
    read(pose, seen_);
    std::copy(seen_.values.begin(), seen_.values.end(), row(kSeen));
    for (int c = 0; c < Rendering::kChannels; ++c)
      std::copy(seen_.inside.begin(), seen_.inside.end(),
                inside_.begin() + static_cast<std::ptrdiff_t>(c * object_.padded()));
    return 2 * product(seen_.inside, seen_.inside.data()) >= object_.size;
  }

  void read(const Pose2D& pose, Reading& reading);
  void differentiate(const Pose2D& pose);
  cv::Mat1d solve(int unknowns);
  double weigh();

  /// The scales of what fits badly are those of the residuals at the start.
  double first_cost() {
    constexpr std::array<float, Rendering::kChannels> kQuantised{6, 4, 4};  // noise explains
    update_residual();
    const std::size_t padded = object_.padded();
    std::vector<float> sizes;
    for (std::size_t axis = 0; axis < scales_.size(); ++axis) {
      sizes.clear();
      for (std::size_t i = axis * padded; i < (axis + 1) * padded; ++i)
        if (inside_[i] > 0) sizes.push_back(std::abs(residual_[i]));
      const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
      std::nth_element(sizes.begin(), middle, sizes.end());
      scales_[axis] = std::max(kQuantised[axis], 2 * *middle);
    }
    return weigh();
  }

  /// What the best light leaves unexplained.
  void update_residual() {
    const cv::Mat1d light = solve(kLight);
    std::copy(row(kSeen), row(kSeen) + count(), residual_.begin());
    for (int k = 0; k < kLight; ++k) subtract(residual_, light(k), row(k));
  }

  cv::Vec3d next_step(const Pose2D& pose) {
    constexpr double kMost = 1;  // [px]
    differentiate(pose);
    const cv::Mat1d unknowns = solve(kUnknowns);
    const cv::Vec3d step(unknowns(kLight), unknowns(kLight + 1), unknowns(kLight + 2));
    return step * std::min(1.0, kMost / (cv::norm(step) + 1e-9));
  }

  const Rendering& object_;
  const SceneLevel& scene_;
  std::vector<float> rows_;  // light, less the slopes of what is seen [per px], what is seen
  std::vector<float> weights_, residual_;
  std::vector<float> inside_;  // that of what is seen, for each channel
  Reading seen_;
  std::array<float, Rendering::kChannels> scales_{};  // [grey levels] of bad residuals, per axis
};

void RenderingFit::read(const Pose2D& pose, Reading& reading) {
  using Colours = std::array<std::vector<float>, 4>;
  constexpr int kInside = 3;
  const std::size_t padded = object_.padded();
  thread_local Colours own;
  thread_local std::array<Colours, 2> beyond;
  const auto sample = [&](const Rendering::Places& places, Colours& colours) {
    for (auto& values : colours) values.resize(padded);
    kernels::sample_colours(
        view_of(scene_.colour), {places[0].data(), places[1].data(), static_cast<int>(padded)},
        placement_of(pose),
        {colours[0].data(), colours[1].data(), colours[2].data(), colours[kInside].data()});
  };
  sample(object_.points, own);
  for (int k = 0; k < 2; ++k) sample(object_.beyond[k], beyond[k]);
  reading.values.assign(count(), 0.f);
  reading.inside.assign(padded, 0.f);
  for (std::size_t i = 0; i < padded; ++i) {
    const float share = object_.background[i];
    const float seen = beyond[0][kInside][i] + beyond[1][kInside][i];
    if (own[kInside][i] == 0 || (share > 0 && seen == 0)) continue;
    reading.inside[i] = 1;
    const float part = share > 0 ? share / seen : 0;
    for (int c = 0; c < Rendering::kChannels; ++c)
      reading.values[c * padded + i] = own[c][i] - part * (beyond[0][c][i] + beyond[1][c][i]);
  }
  Rendering::turn_to_axes(reading.values.data(), padded);
}

/// Central differences along x, y and the rim.
void RenderingFit::differentiate(const Pose2D& pose) {
  constexpr double kStep = 0.5;  // [px]
  Reading low, high;
  for (int k = 0; k < kMotion; ++k) {
    Pose2D before = pose, after = pose;
    double* const moved[] = {&before.x, &before.y, &before.theta, &after.x, &after.y, &after.theta};
    const double step = k == 2 ? kStep / object_.radius : kStep;
    *moved[k] -= step;
    *moved[kMotion + k] += step;
    read(before, low);
    read(after, high);
    float* const slopes = row(kLight + k);
    const std::size_t padded = object_.padded();
    for (std::size_t first = 0; first < count(); first += padded)
      for (std::size_t point = 0; point < padded; ++point) {
        const std::size_t i = first + point;
        const bool known = low.inside[point] > 0 && high.inside[point] > 0;
        slopes[i] = known ? (low.values[i] - high.values[i]) / static_cast<float>(2 * kStep) : 0.f;
      }
  }
}

/// Least squares for the first `unknowns` rows, which are to add up to what is seen.
cv::Mat1d RenderingFit::solve(int unknowns) {
  constexpr double kGain = 400, kOffset = 5e-4, kShading = 0.02;  // priors, per point
  thread_local std::vector<float> weighted;
  weighted.resize(count());
  cv::Mat1d products(unknowns, unknowns), sums(unknowns, 1);
  for (int k = 0; k < unknowns; ++k) {
    const float* const values = row(k);
    for (std::size_t i = 0; i < count(); ++i) weighted[i] = weights_[i] * inside_[i] * values[i];
    float found[kRows];
    kernels::dots(row(k), count(), kRows - k, weighted.data(), static_cast<int>(count()), found);
    for (int j = k; j < unknowns; ++j) products(k, j) = products(j, k) = found[j - k];
    sums(k) = found[kSeen - k];
  }
  for (int k = 0; k < unknowns; ++k)
    products(k, k) += object_.size * (k == 0                      ? kGain
                                      : k <= Rendering::kChannels ? kOffset
                                                                  : kShading);
  sums(0) += object_.size * kGain;
  cv::Mat1d found;
  if (!cv::solve(products, sums, found, cv::DECOMP_CHOLESKY)) found = cv::Mat1d::zeros(unknowns, 1);
  return found;
}

/// Weighs the values by how well they fit in the best light. Returns their mean misfit, in which
/// large ones saturate.
double RenderingFit::weigh() {
  update_residual();
  double misfit = 0, inside_count = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    const float scale = scales_[i / object_.padded()];
    const float square = residual_[i] * residual_[i] / (scale * scale);
    const float telling = scales_[0] / (scale * (1 + square));
    weights_[i] = telling * telling;
    misfit += inside_[i] * square / (1 + square);
    inside_count += inside_[i];
  }
  return misfit / inside_count;
}

/// Of the residuals.
double RenderingFit::misfit() const {
  constexpr float kWorst = 60 * 60;  // [grey^2] of one value
  double sum = 0, seen = 0;
  for (std::size_t i = 0; i < count(); ++i) {
    sum += inside_[i] * std::min(residual_[i] * residual_[i], kWorst);
    seen += inside_[i];
  }
  return std::log(std::sqrt(sum / seen) + 3);
}

/// Of what is explained, against what was taught.
double RenderingFit::brightness() {
  constexpr double kDark = 8;  // [grey levels] added before taking the logarithm
  const float* const seen = row(kSeen);
  const float* const taught = row(0);
  double explained = 0, learned = 0, size = 0;
  for (std::size_t i = 0; i < object_.padded(); ++i) {
    explained += inside_[i] * (seen[i] - residual_[i]);
    learned += inside_[i] * taught[i];
    size += std::sqrt(3.) * inside_[i] * (1 - object_.background[i]);
  }
  return std::log((std::max(0.0, explained / size) + kDark) /
                  (std::max(0.0, learned / size) + kDark));
}

}  // namespace

Rendered fit(const Rendering& object, const SceneLevel& scene, const Pose2D& start) {
  return object.padded() == 0 ? Rendered{start} : RenderingFit(object, scene).run(start);
}

}  // namespace mbncc
