// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/sim/scene.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "sim/drawing.hpp"
#include "sim/random.hpp"
#include "sim/scene_cache.hpp"
#include "sim/texture.hpp"

namespace mbncc::sim {
namespace {

constexpr double kContactShadow = 4;  // [px] blur of the shadow of things on the platform
constexpr double kArmShadow = 14;     // [px] wider, because the arm is higher up

/// CV_32FC3 light that falls off by `gradient` from edge to edge, in a direction that depends on
/// the seed.
cv::Mat light_field(const SceneConfig& config) {
  cv::RNG random = generator(config.seed, 5);
  const cv::Point2d direction = rotate({1, 0}, random.uniform(0.0, 2 * kPi));
  const double diagonal = std::hypot(config.size.width, config.size.height);
  cv::Mat light(config.size, CV_32FC3);
  for (int y = 0; y < light.rows; ++y) {
    for (int x = 0; x < light.cols; ++x) {
      const cv::Point2d from_centre(x - light.cols / 2.0, y - light.rows / 2.0);
      const double value = 1 + config.light_gradient * from_centre.dot(direction) / diagonal;
      light.at<cv::Vec3f>(y, x) = cv::Vec3f::all(static_cast<float>(config.gain * value));
    }
  }
  return light;
}

/// 8-bit values of `image` with sensor noise: a constant part, and a part whose variance grows with
/// the signal.
cv::Mat sense(const cv::Mat& image, double sigma, cv::RNG random) {
  cv::Mat result(image.size(), CV_8UC3), noise(1, image.cols, CV_32FC3);
  for (int y = 0; y < image.rows; ++y) {
    random.fill(noise, cv::RNG::NORMAL, 0, sigma);
    const float* signal = image.ptr<float>(y);
    const float* deviate = noise.ptr<float>();
    uchar* value = result.ptr(y);
    for (int i = 0; i < 3 * image.cols; ++i) {
      const float share = std::sqrt(0.5f + std::max(signal[i], 0.0f) * (0.5f / 128));
      value[i] = cv::saturate_cast<uchar>(signal[i] + deviate[i] * share);
    }
  }
  return result;
}

void draw_over(const Arm& arm, cv::Mat& image) {
  static const Drawing body = draw_arm_body(), finger = draw_finger(), other = mirrored(finger);
  const double half = arm.opening / 2;
  composite(finger, compose(arm.grip, {0, half, 0}), kArmShadow, image);
  composite(other, compose(arm.grip, {0, -half, 0}), kArmShadow, image);
  composite(body, arm.grip, kArmShadow, image);
}

}  // namespace

Scene::Scene(SceneConfig config) : config_(config), cache_(std::make_shared<SceneCache>()) {
  if (config_.size.width < 16 || config_.size.height < 16)
    throw std::invalid_argument("a scene needs at least 16 x 16 pixels");
  platform_ = platform_texture(config_.size, config_.seed);
  light_ = light_field(config_);
}

cv::Mat Scene::compose_at_rest(const std::vector<Placed>& placed) const {
  return cache_->composition(placed, [&] {
    cv::Mat image = platform_.clone();
    for (const auto& thing : placed)
      composite(*cache_->drawing(thing.object), thing.pose, kContactShadow, image);
    return image;
  });
}

cv::Mat Scene::render(const std::vector<Placed>& placed, std::uint64_t frame,
                      const std::optional<Arm>& arm) const {
  cv::Mat image = compose_at_rest(placed);
  if (arm) {
    image = image.clone();
    draw_over(*arm, image);
  }
  cv::Mat lit = image.mul(light_);
  if (config_.blur_sigma > 0) cv::GaussianBlur(lit, lit, {}, config_.blur_sigma);
  return sense(lit, config_.noise_sigma, generator(mix(config_.seed, 6), frame));
}

cv::Mat Scene::true_map(const Placed& placed) const {
  cv::Mat map = cv::Mat::zeros(config_.size, CV_8UC1);
  cv::Rect where;
  const cv::Mat cover = coverage(*cache_->drawing(placed.object), placed.pose, config_.size, where);
  if (!where.empty()) cv::Mat(cover >= 0.5).copyTo(map(where));
  return map;
}

}  // namespace mbncc::sim
