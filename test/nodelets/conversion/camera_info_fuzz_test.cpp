// SPDX-License-Identifier: BSD-3-Clause
// Random calibrations, valid and corrupted: a pose in metres is given only if it agrees with an
// independent computation from camera_info.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "nodelets/conversion/calibration.hpp"

namespace mbncc::nodelets {
namespace {

constexpr int kMessages = 8000;
constexpr int kPixels = 3;             // number of pixels per message
constexpr double kMostError = 1e-3;    // [m]
constexpr double kFarthest = 100.001;  // [m] largest distance of a plausible position
constexpr double kTolerance = 2e-6;    // tolerance of entries that the definition fixes
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

using sensor_msgs::CameraInfo;

/// One message, the image that it belongs to, and the platform.
struct Case {
  CameraInfo info;
  bool rectified = false;
  cv::Size size;
  double distance = 0;  // [m]; 0: from tf
  cv::Matx44d T_camera_platform = cv::Matx44d::eye();
  double object_height = 0;  // [m]
};

/// The meaning of the message, computed from the definition in CameraInfo.msg.
namespace truth {

bool is(double value, double wanted) {
  return std::abs(value - wanted) <= kTolerance;
}

/// The pixel on the sensor; none if the image does not fit the message.
std::optional<cv::Point2d> on_sensor(const Case& c, cv::Point2d pixel) {
  const auto& roi = c.info.roi;
  const bool none = roi.x_offset + roi.y_offset + roi.width + roi.height == 0;
  const double width = none ? c.info.width : roi.width, height = none ? c.info.height : roi.height;
  const double bx = std::max(1u, c.info.binning_x), by = std::max(1u, c.info.binning_y);
  if (double(roi.x_offset) + width > c.info.width || double(roi.y_offset) + height > c.info.height)
    return {};
  if (c.size.width != std::floor(width / bx) || c.size.height != std::floor(height / by)) return {};
  return cv::Point2d(roi.x_offset + bx * pixel.x + (bx - 1) / 2,
                     roi.y_offset + by * pixel.y + (by - 1) / 2);
}

/// No real lens is so short, so long or so far off axis.
bool is_possible(double fx, double fy, double cx, double cy, const CameraInfo& info) {
  const double side = std::max(info.width, info.height);
  const auto possible = [side](double f) { return f > 0.05 * side && f < 200 * side; };
  return possible(fx) && possible(fy) && std::abs(cx) < 2.5 * info.width &&
         std::abs(cy) < 2.5 * info.height;
}

/// The direction (x, y, 1) for which P (x, y, 1, 1/z) is the pixel, for a point at depth z.
std::optional<cv::Vec3d> rectified_ray(const CameraInfo& info, cv::Point2d pixel, double z) {
  const auto& p = info.P;
  if (!is_possible(p[0], p[5], p[2], p[6], info)) return {};
  const double a = p[0] - pixel.x * p[8], b = p[1] - pixel.x * p[9];
  const double c = p[4] - pixel.y * p[8], d = p[5] - pixel.y * p[9];
  const double right_x = pixel.x * (p[10] + p[11] / z) - p[2] - p[3] / z;
  const double right_y = pixel.y * (p[10] + p[11] / z) - p[6] - p[7] / z;
  const double determinant = a * d - b * c;
  return cv::Vec3d((right_x * d - b * right_y) / determinant,
                   (a * right_y - right_x * c) / determinant, 1);
}

using Vector = std::array<double, 2>;

/// Applies the distortion of CameraInfo's models to a direction (x, y, 1).
Vector distort(const CameraInfo& info, const Vector& v) {
  const auto& d = info.D;
  const double x = v[0], y = v[1], r2 = x * x + y * y, r = std::sqrt(r2);
  if (info.distortion_model == "equidistant") {
    const double t = std::atan(r), t2 = t * t;
    const double td = t * (1 + t2 * (d[0] + t2 * (d[1] + t2 * (d[2] + t2 * d[3]))));
    const double scale = r > 0 ? td / r : 1;
    return {x * scale, y * scale};
  }
  const double k3 = d.size() > 4 ? d[4] : 0;
  double radial = 1 + r2 * (d[0] + r2 * (d[1] + r2 * k3));
  if (d.size() == 8) radial /= 1 + r2 * (d[5] + r2 * (d[6] + r2 * d[7]));
  return {x * radial + 2 * d[2] * x * y + d[3] * (r2 + 2 * x * x),
          y * radial + d[2] * (r2 + 2 * y * y) + 2 * d[3] * x * y};
}

/// Follows the distortion outwards from the axis in `steps` steps, so that the result is not on a
/// branch beyond a fold.
std::optional<Vector> undistort(const CameraInfo& info, const Vector& wanted, int steps) {
  constexpr double kStep = 1e-7;
  Vector v{0, 0};
  for (int step = 1; step <= steps; ++step) {
    const double part = double(step) / steps;
    for (int round = 0; round < 20; ++round) {
      const Vector at = distort(info, v);
      const Vector off{part * wanted[0] - at[0], part * wanted[1] - at[1]};
      const Vector dx = distort(info, {v[0] + kStep, v[1]}),
                   dy = distort(info, {v[0], v[1] + kStep});
      const double a = (dx[0] - at[0]) / kStep, b = (dy[0] - at[0]) / kStep;
      const double c = (dx[1] - at[1]) / kStep, d = (dy[1] - at[1]) / kStep;
      const double determinant = a * d - b * c;
      if (!(determinant > 1e-6)) return {};
      v = {v[0] + (off[0] * d - b * off[1]) / determinant,
           v[1] + (a * off[1] - off[0] * c) / determinant};
    }
    const Vector at = distort(info, v);
    if (!(std::hypot(part * wanted[0] - at[0], part * wanted[1] - at[1]) < 1e-9)) return {};
  }
  return v;
}

bool is_known_lens(const CameraInfo& info) {
  const std::string& model = info.distortion_model;
  const std::size_t n = info.D.size();
  return (model == "plumb_bob" && (n == 4 || n == 5)) ||
         (model == "rational_polynomial" && n == 8) || (model == "equidistant" && n == 4);
}

std::optional<cv::Vec3d> raw_ray(const CameraInfo& info, cv::Point2d pixel) {
  const auto& k = info.K;
  if (!is_possible(k[0], k[4], k[2], k[5], info)) return {};
  if (!is(k[1], 0) || !is(k[3], 0) || !is(k[6], 0) || !is(k[7], 0) || !is(k[8], 1)) return {};
  // The rays of a raw image are in the camera's frame only if R does not rotate it.
  const std::array<double, 9> one{1, 0, 0, 0, 1, 0, 0, 0, 1};
  bool same = true, none = true;
  for (std::size_t i = 0; i < 9; ++i) {
    same = same && is(info.R[i], one[i]);
    none = none && info.R[i] == 0;
  }
  if (!same && !none) return {};
  const Vector distorted{(pixel.x - k[2]) / k[0], (pixel.y - k[5]) / k[4]};
  const bool no_numbers =
      std::all_of(info.D.begin(), info.D.end(), [](double d) { return d == 0; });
  if (no_numbers && info.distortion_model != "equidistant")
    return cv::Vec3d(distorted[0], distorted[1], 1);
  if (!is_known_lens(info)) return {};
  auto straight = undistort(info, distorted, 200);
  if (!straight) straight = undistort(info, distorted, 20000);  // unusual lenses need small steps
  if (!straight) return {};
  return cv::Vec3d((*straight)[0], (*straight)[1], 1);
}

/// Intersection of the ray with the object's top face; none unless it lies in front of the camera
/// at a plausible distance.
std::optional<cv::Vec3d> place_on(const cv::Vec3d& ray, const Case& c) {
  cv::Vec3d point(0, 0, c.distance), normal(0, 0, -1);
  if (c.distance == 0) {
    const auto& t = c.T_camera_platform;
    point = {t(0, 3), t(1, 3), t(2, 3)};
    normal = {t(0, 2), t(1, 2), t(2, 2)};
    if (normal.dot(point) > 0) normal = -normal;  // towards the camera
  }
  point += c.object_height * normal;
  if (!(normal.dot(point) < 0)) return {};  // the camera is below the top face
  const double along = normal.dot(point) / normal.dot(ray);
  const cv::Vec3d place = along * ray;
  if (!(along > 0) || !(cv::norm(place) < kFarthest)) return {};
  return place;
}

std::optional<cv::Vec3d> place_of(const Case& c, cv::Point2d pixel) {
  const auto full = on_sensor(c, pixel);
  if (!full) return {};
  if (!c.rectified) {
    const auto ray = raw_ray(c.info, *full);
    return ray ? place_on(*ray, c) : std::nullopt;
  }
  // A baseline shifts the ray, so its depth is found by iteration.
  double z = c.distance == 0 ? c.T_camera_platform(2, 3) : c.distance;
  std::optional<cv::Vec3d> place;
  for (int round = 0; round < 30; ++round) {
    const auto ray = rectified_ray(c.info, *full, z);
    place = ray ? place_on(*ray, c) : std::nullopt;
    if (!place) return {};
    z = (*place)[2];
  }
  return place;
}

}  // namespace truth

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : random_(seed) {}

  Case sound() {
    Case c;
    const std::array<cv::Size, 5> sizes{
        {{640, 480}, {1280, 960}, {320, 240}, {1280, 720}, {480, 640}}};
    const cv::Size sensor = sizes[index(sizes.size())];
    auto& info = c.info;
    info.width = static_cast<std::uint32_t>(sensor.width);
    info.height = static_cast<std::uint32_t>(sensor.height);
    c.rectified = chance(0.4);
    const double side = std::max(sensor.width, sensor.height);
    const double fx = side * number(0.5, 2), fy = fx * number(0.97, 1.03);
    const double cx = sensor.width * number(0.4, 0.6), cy = sensor.height * number(0.4, 0.6);
    info.K = {fx, 0, cx, 0, fy, cy, 0, 0, 1};
    info.P = {fx * 0.9, 0, cx + 3, 0, 0, fy * 0.9, cy - 4, 0, 0, 0, 1, 0};
    if (chance(0.7)) info.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    lens(info);
    window(c);
    platform(c);
    return c;
  }

  void spoil(Case& c) {
    using Spoil = std::function<void(Case&)>;
    static const std::vector<std::string> kModels{
        "", "plumb_bob", "rational_polynomial", "equidistant", "some_lens", "Plumb_Bob", "\n"};
    const std::vector<Spoil> ways{
        [this](Case& d) { number_of(d.info) = special(); },
        [this](Case& d) { number_of(d.info) = special(); },
        [this](Case& d) { number_of(d.info) *= number(-3, 3); },
        [this](Case& d) { number_of(d.info) += std::pow(10, number(-8, 3)); },
        [this](Case& d) { d.info.D.resize(index(15), number(-0.2, 0.2)); },
        [this](Case& d) { d.info.D.assign(index(15), 0); },
        [this](Case& d) {
          for (double& value : d.info.D) value *= std::pow(10, number(-1, 4));
        },
        [this](Case& d) { d.info.distortion_model = kModels[index(kModels.size())]; },
        [this](Case& d) { *side_of(d.info) = whole(); },
        [this](Case& d) { *side_of(d.info) += static_cast<std::uint32_t>(index(3)) - 1; },
        [this](Case& d) { (chance(0.5) ? d.info.binning_x : d.info.binning_y) = whole(); },
        [](Case& d) { std::swap(d.info.width, d.info.height); },
        [](Case& d) { d.info.K = {1, 0, 0, 0, 1, 0, 0, 0, 1}; },
        [](Case& d) { d.info.K.fill(0); },
        [](Case& d) { d.info.P.fill(0); },
        [](Case& d) { std::swap(d.info.K[2], d.info.K[6]), std::swap(d.info.K[5], d.info.K[7]); },
        [this](Case& d) { scale_focus(d.info, std::pow(10, number(-3, 3))); },
        [this](Case& d) { d.info.P[3 + 4 * index(3)] = number(-50, 50); },
        [this](Case& d) { turn(d.info); },
        [this](Case& d) { d.size.width += static_cast<int>(index(5)) - 2; },
        [this](Case& d) { d.object_height = number(0, 10); },
        [this](Case& d) { d.distance = number(0, 1) < 0.5 ? 1e-4 : 100; },
        [this](Case& d) { move_platform(d, std::pow(10, number(-3, 6))); }};
    for (std::size_t i = 0; i <= index(3); ++i) ways[index(ways.size())](c);
  }

  cv::Point2d pixel(cv::Size size) {
    return {number(0, std::max(1, size.width)), number(0, std::max(1, size.height))};
  }

  bool chance(double part) { return number(0, 1) < part; }

 private:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  std::size_t index(std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
  }
  std::uint32_t whole() {
    const std::array<std::uint32_t, 9> numbers{
        {0, 1, 2, 3, 7, 640, 65537, 0x7fffffffu, 0xffffffffu}};
    return numbers[index(numbers.size())];
  }
  double special() {
    const std::array<double, 16> numbers{{0, 1, -1, 1e9, -1e9, 1e308, -1e308, 1e-300, 1e-9, 5e-324,
                                          1e5, 1e-3, kNan, kInfinity, -kInfinity, 100}};
    return numbers[index(numbers.size())];
  }

  /// A random one of the message's numbers.
  double& number_of(CameraInfo& info) {
    const std::size_t i = index(30 + info.D.size());
    if (i < 9) return info.K[i];
    if (i < 21) return info.P[i - 9];
    if (i < 30) return info.R[i - 21];
    return info.D[i - 30];
  }
  std::uint32_t* side_of(CameraInfo& info) {
    auto& roi = info.roi;
    const std::array<std::uint32_t*, 6> sides{
        {&info.width, &info.height, &roi.x_offset, &roi.y_offset, &roi.width, &roi.height}};
    return sides[index(sides.size())];
  }

  void lens(CameraInfo& info) {
    info.distortion_model = "plumb_bob";
    switch (index(6)) {
      case 0:
        info.D = {number(-0.4, 0.3), number(-0.1, 0.2), number(-0.005, 0.005),
                  number(-0.005, 0.005), number(-0.05, 0.05)};
        break;
      case 1:
        info.D = {number(-0.4, 0.3), number(-0.1, 0.2), number(-0.005, 0.005),
                  number(-0.005, 0.005)};
        break;
      case 2:
        info.distortion_model = "rational_polynomial";
        info.D = {number(0, 1),   number(-0.1, 0.2), number(-0.002, 0.002), number(-0.002, 0.002),
                  number(0, 0.1), number(0.2, 1.4),  number(0, 0.3),        number(0, 0.1)};
        break;
      case 3:
        info.distortion_model = "equidistant";
        info.D = {number(-0.1, 0.1), number(-0.02, 0.02), number(-0.01, 0.01), number(-0.01, 0.01)};
        break;
      case 4:
        info.D.assign(5, 0);
        break;
      default:
        info.distortion_model = "";
        break;
    }
  }

  void window(Case& c) {
    auto& info = c.info;
    std::uint32_t width = info.width, height = info.height;
    if (chance(0.4)) {
      auto& roi = info.roi;
      width = roi.width = static_cast<std::uint32_t>(number(0.3, 1) * width);
      height = roi.height = static_cast<std::uint32_t>(number(0.3, 1) * height);
      roi.x_offset = static_cast<std::uint32_t>(index(info.width - width + 1));
      roi.y_offset = static_cast<std::uint32_t>(index(info.height - height + 1));
    }
    if (chance(0.4)) info.binning_x = static_cast<std::uint32_t>(index(5));
    if (chance(0.4)) info.binning_y = static_cast<std::uint32_t>(index(5));
    c.size = cv::Size(static_cast<int>(width / std::max(1u, info.binning_x)),
                      static_cast<int>(height / std::max(1u, info.binning_y)));
  }

  void platform(Case& c) {
    c.object_height = number(0, 0.1);
    if (chance(0.5)) {
      c.distance = number(0.3, 1.5);
      return;
    }
    // The platform is tilted and faces the camera.
    const double tilt = CV_PI + number(-0.5, 0.5), cosine = std::cos(tilt), sine = std::sin(tilt);
    c.T_camera_platform = {1, 0,    0,      number(-0.2, 0.2), 0, cosine, -sine, number(-0.2, 0.2),
                           0, sine, cosine, number(0.3, 1.5),  0, 0,      0,     1};
  }

  void move_platform(Case& c, double distance) {
    c.distance = 0;
    c.T_camera_platform(2, 3) = chance(0.5) ? distance : -distance;
  }

  static void scale_focus(CameraInfo& info, double factor) {
    for (const std::size_t i : {0, 4}) info.K[i] *= factor;
    for (const std::size_t i : {0, 5}) info.P[i] *= factor;
  }

  void turn(CameraInfo& info) {
    const double angle = std::pow(10, number(-9, 0.4)), c = std::cos(angle), s = std::sin(angle);
    info.R = {c, -s, 0, s, c, 0, 0, 0, 1};
  }

  std::mt19937_64 random_;
};

geometry_msgs::TransformStamped transform_of(const cv::Matx44d& matrix) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "camera";
  transform.child_frame_id = "platform";
  transform.header.stamp = ros::Time(10);
  const double tilt = std::atan2(matrix(2, 1), matrix(1, 1));
  transform.transform.rotation.x = std::sin(tilt / 2);
  transform.transform.rotation.w = std::cos(tilt / 2);
  transform.transform.translation.x = matrix(0, 3);
  transform.transform.translation.y = matrix(1, 3);
  transform.transform.translation.z = matrix(2, 3);
  return transform;
}

Calibration calibration_of(const Case& c) {
  PlatformConfig config;
  config.rectified = c.rectified;
  config.platform_distance = c.distance;
  tf2_ros::Buffer tf;
  if (c.distance == 0) {
    config.platform_frame = "platform";
    tf.setTransform(transform_of(c.T_camera_platform), "test", true);
  }
  std_msgs::Header header;
  header.frame_id = "camera";
  header.stamp = ros::Time(10);
  return calibrate(config, &c.info, header, c.size, tf);
}

std::string text_of(const Case& c) {
  std::ostringstream text;
  text.precision(17);
  text << c.info << "\n"
       << c.size << (c.rectified ? " rectified" : " raw") << ", platform at " << c.distance
       << " m or\n"
       << c.T_camera_platform << "\nheight " << c.object_height;
  return text.str();
}

TEST(CameraInfoFuzz, PosesAreGivenOnlyForUsableMessages) {
  Generator generator(77);
  int posed = 0, refused = 0, sound = 0, sound_posed = 0;
  for (int i = 0; i < kMessages; ++i) {
    Case c = generator.sound();
    const bool spoilt = generator.chance(0.7);
    if (spoilt) generator.spoil(c);
    const Calibration calibration = calibration_of(c);
    ASSERT_NE(calibration.platform.has_value(), !calibration.fault.empty()) << text_of(c);
    for (int j = 0; j < kPixels; ++j) {
      const cv::Point2d pixel = generator.pixel(c.size);
      const auto expected = truth::place_of(c, pixel);
      const auto pose = calibration.platform
                            ? calibration.platform->lift({pixel.x, pixel.y, 0.3},
                                                         cv::Matx33d::eye(), c.object_height)
                            : std::nullopt;
      ++(pose ? posed : refused);
      if (!spoilt && expected) {
        ++sound;
        sound_posed += pose ? 1 : 0;
      }
      if (!pose) continue;
      ASSERT_TRUE(expected) << "message " << i << ", pixel " << pixel << "\n" << text_of(c);
      ASSERT_LT(cv::norm(pose->position - *expected), kMostError)
          << "message " << i << ", pixel " << pixel << ": " << pose->position << " instead of "
          << *expected << "\n"
          << text_of(c);
    }
  }
  RecordProperty("posed", posed);
  RecordProperty("refused", refused);
  std::cout << posed << " poses, " << refused << " refused; of " << sound << " of sound messages "
            << sound_posed << " given\n";
  EXPECT_GT(sound_posed, 0.99 * sound) << "what is sound is used";
  EXPECT_GT(refused, 2000) << "and much was spoilt";
}

}  // namespace
}  // namespace mbncc::nodelets
