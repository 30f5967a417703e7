// SPDX-License-Identifier: BSD-3-Clause
#include "sim/texture.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/random.hpp"

namespace mbncc::sim {
namespace {

cv::Mat filled(cv::Size size, const cv::Scalar& colour) {
  return cv::Mat(size, CV_32FC3, colour);
}

cv::Point random_point(cv::Size size, cv::RNG& random) {
  return {random.uniform(0, size.width), random.uniform(0, size.height)};
}

/// Adds `noise` (CV_32FC1) times `amplitude` per channel.
void add_noise(cv::Mat& surface, const cv::Mat& noise, const cv::Scalar& amplitude) {
  cv::Mat channels[3];
  for (int c = 0; c < 3; ++c) channels[c] = noise * amplitude[c];
  cv::Mat coloured;
  cv::merge(channels, 3, coloured);
  surface += coloured;
}

void draw_scratches(cv::Mat& surface, int count, double length, int thickness, cv::RNG& random) {
  for (int i = 0; i < count; ++i) {
    const cv::Point start = random_point(surface.size(), random);
    const double angle = random.uniform(0.0, CV_PI), reach = length * random.uniform(0.3, 1.0);
    const cv::Point end(cvRound(start.x + reach * std::cos(angle)),
                        cvRound(start.y + reach * std::sin(angle)));
    cv::line(surface, start, end, cv::Scalar::all(random.uniform(40.0, 215.0)), thickness);
  }
}

void draw_specks(cv::Mat& surface, int count, double radius, cv::RNG& random) {
  for (int i = 0; i < count; ++i) {
    const cv::Scalar colour = colour_of(random.uniform(0.0, 360.0), random.uniform(0.0, 0.5),
                                        random.uniform(30.0, 220.0));
    cv::circle(surface, random_point(surface.size(), random),
               cvRound(radius * random.uniform(0.4, 1.0)), colour, cv::FILLED);
  }
}

/// Replaces the surface by `colour` where `noise` exceeds `level`.
void paint_patches(cv::Mat& surface, const cv::Mat& noise, double level, const cv::Scalar& colour) {
  surface.setTo(colour, noise > level);
}

void draw_bands(cv::Mat& surface, double scale, const cv::Scalar& colour, cv::RNG& random) {
  const double angle = random.uniform(0.0, CV_PI);
  const cv::Point2d along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
  const cv::Point2d centre(surface.cols / 2.0, surface.rows / 2.0);
  const double reach = surface.cols + surface.rows;
  for (int i = 0; i < 2; ++i) {
    const cv::Point2d middle = centre + across * (surface.cols * random.uniform(-0.3, 0.3));
    cv::line(surface, middle - along * reach, middle + along * reach, colour,
             std::max(1, cvRound(scale * random.uniform(2.0, 7.0))));
  }
}

void print_marks(cv::Mat& surface, double scale, const cv::Scalar& ink, cv::RNG& random) {
  const char* kWords[] = {"A7", "K-2", "415", "QX", "82B", "M6", "ZE", "R30"};
  const double height = surface.rows / scale / 90.0;
  for (int i = 0; i < 3; ++i) {
    const cv::Point where(cvRound(surface.cols * random.uniform(0.15, 0.6)),
                          cvRound(surface.rows * random.uniform(0.25, 0.85)));
    cv::putText(surface, kWords[random.uniform(0, 8)], where, cv::FONT_HERSHEY_DUPLEX,
                scale * height * random.uniform(0.5, 0.9), ink,
                std::max(1, cvRound(scale * height * 1.4)));
  }
}

}  // namespace

cv::Scalar colour_of(double hue, double saturation, double value) {
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + hue / 60, 6.0);
    return value * (1 - saturation * std::max(0.0, std::min({k, 4 - k, 1.0})));
  };
  return {channel(1), channel(3), channel(5)};
}

cv::Mat fractal_noise(cv::Size size, double coarsest, double finest, cv::RNG& random) {
  cv::Mat sum = cv::Mat::zeros(size, CV_32FC1);
  double variance = 0;
  for (double feature = coarsest; feature >= finest; feature /= 2) {
    const cv::Size grid(std::max(2, cvCeil(size.width / feature) + 1),
                        std::max(2, cvCeil(size.height / feature) + 1));
    cv::Mat values(grid, CV_32FC1), octave;
    random.fill(values, cv::RNG::NORMAL, 0, 1);
    cv::resize(values, octave, size, 0, 0, cv::INTER_CUBIC);
    sum += octave * std::sqrt(feature);
    variance += feature;
  }
  // Cubic interpolation keeps about half of the grid's variance.
  return sum / std::sqrt(0.5 * variance);
}

cv::Mat platform_texture(cv::Size size, std::uint64_t seed) {
  cv::RNG random = generator(seed, 1);
  const double hue = random.uniform(15.0, 220.0);
  cv::Mat surface = filled(size, colour_of(hue, random.uniform(0.1, 0.35), 125));
  add_noise(surface, fractal_noise(size, 128, 2, random), cv::Scalar::all(13));
  add_noise(surface, fractal_noise(size, 64, 8, random), {7, 0, -7});
  const int area = size.area();
  draw_scratches(surface, area / 3000, 60, 1, random);
  draw_specks(surface, area / 2500, 3, random);
  add_noise(surface, fractal_noise(size, 4, 1, random), cv::Scalar::all(9));
  return surface;
}

cv::Mat object_texture(cv::Size size, double scale, std::uint64_t seed) {
  cv::RNG random = generator(seed, 2);
  const double hue = random.uniform(0.0, 360.0);
  const double other = std::fmod(hue + random.uniform(60.0, 300.0), 360.0);
  const double value = random.uniform(110.0, 200.0);
  const cv::Scalar ink = cv::Scalar::all(value > 155 ? 35 : 225);
  cv::Mat surface = filled(size, colour_of(hue, random.uniform(0.35, 0.8), value));
  const double extent = size.width;
  paint_patches(surface, fractal_noise(size, extent / 4, extent / 8, random), 0.6,
                colour_of(other, random.uniform(0.2, 0.7), random.uniform(60.0, 220.0)));
  draw_bands(surface, scale, colour_of(other, 0.3, random.uniform(40.0, 230.0)), random);
  print_marks(surface, scale, ink, random);
  draw_scratches(surface, 12, extent / 3, cvRound(scale / 2), random);
  draw_specks(surface, 25, 1.5 * scale, random);
  add_noise(surface, fractal_noise(size, extent / 3, 2 * scale, random), cv::Scalar::all(10));
  add_noise(surface, fractal_noise(size, 2 * scale, scale, random), cv::Scalar::all(5));
  return surface;
}

}  // namespace mbncc::sim
