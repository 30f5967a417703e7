#include "mbncc/sim/scene.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "sim/drawing.hpp"
#include "sim/random.hpp"
#include "sim/texture.hpp"

namespace mbncc::sim {
namespace {

constexpr double kContactShadow = 4;  // [px] blur of the shadow of things on the platform
constexpr double kArmShadow = 14;     // [px] the arm is higher up

/// CV_32FC3 light falling off by `gradient` from edge to edge in a direction drawn by the seed.
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

/// Sensor noise: a constant part and a part whose variance grows with the signal.
void add_sensor_noise(cv::Mat& picture, double sigma, cv::RNG random) {
  if (sigma <= 0) return;
  cv::Mat noise(picture.size(), CV_32FC3), level;
  random.fill(noise, cv::RNG::NORMAL, 0, sigma);
  cv::max(picture, 0, level);
  cv::sqrt(level * (0.5 / 128) + cv::Scalar::all(0.5), level);
  picture += noise.mul(level);
}

void draw_over(const Arm& arm, cv::Mat& picture) {
  static const Drawing body = draw_arm_body(), finger = draw_finger(), other = mirrored(finger);
  const double half = arm.opening / 2;
  composite(finger, compose(arm.grip, {0, half, 0}), kArmShadow, picture);
  composite(other, compose(arm.grip, {0, -half, 0}), kArmShadow, picture);
  composite(body, arm.grip, kArmShadow, picture);
}

}  // namespace

Scene::Scene(SceneConfig config) : config_(config), drawings_(std::make_shared<DrawingCache>()) {
  if (config_.size.width < 16 || config_.size.height < 16)
    throw std::invalid_argument("a scene needs at least 16 x 16 pixels");
  platform_ = platform_texture(config_.size, config_.seed);
  light_ = light_field(config_);
}

cv::Mat Scene::render(const std::vector<Placed>& placed, std::uint64_t frame,
                      const std::optional<Arm>& arm) const {
  cv::Mat picture = platform_.clone();
  for (const auto& thing : placed)
    composite(*drawings_->get(thing.object), thing.pose, kContactShadow, picture);
  if (arm) draw_over(*arm, picture);
  picture = picture.mul(light_);
  if (config_.blur_sigma > 0) cv::GaussianBlur(picture, picture, {}, config_.blur_sigma);
  add_sensor_noise(picture, config_.noise_sigma, generator(mix(config_.seed, 6), frame));
  cv::Mat result;
  picture.convertTo(result, CV_8UC3);
  return result;
}

cv::Mat Scene::true_map(const Placed& placed) const {
  cv::Mat map = cv::Mat::zeros(config_.size, CV_8UC1);
  cv::Rect where;
  const cv::Mat cover = coverage(*drawings_->get(placed.object), placed.pose, config_.size, where);
  if (!where.empty()) cv::Mat(cover >= 0.5).copyTo(map(where));
  return map;
}

}  // namespace mbncc::sim
