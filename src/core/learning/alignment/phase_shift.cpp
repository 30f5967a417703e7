// SPDX-License-Identifier: BSD-3-Clause
#include "learning/alignment/phase_shift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace mbncc::alignment {
namespace {

constexpr int kSmallest = 3;  // [px]
constexpr int kAround = 2;    // [px] neighbourhood of a peak that gives its sub-pixel position

std::vector<float> half_hanning(int size) {
  std::vector<float> window(size);
  for (int i = 0; i < size; ++i)
    window[i] = static_cast<float>(std::sqrt(0.5 * (1 - std::cos(2 * CV_PI * i / (size - 1)))));
  return window;
}

// The image times the square root of a Hanning window, padded to a size with a fast Fourier
// transform.
cv::Mat windowed(const cv::Mat& image) {
  const auto across = half_hanning(image.cols), down = half_hanning(image.rows);
  cv::Mat framed = cv::Mat::zeros(cv::getOptimalDFTSize(image.rows),
                                  cv::getOptimalDFTSize(image.cols), CV_32FC1);
  for (int y = 0; y < image.rows; ++y) {
    const auto* values = image.ptr<float>(y);
    auto* out = framed.ptr<float>(y);
    for (int x = 0; x < image.cols; ++x) out[x] = values[x] * (down[y] * across[x]);
  }
  return framed;
}

void normalise(float& real, float& imaginary) {
  constexpr double kTiny = std::numeric_limits<float>::epsilon();
  const double square = double{real} * real + double{imaginary} * imaginary;
  const double factor = std::sqrt(square) / (square + kTiny);
  real = static_cast<float>(real * factor);
  imaginary = static_cast<float>(imaginary * factor);
}

void normalise(float& real) {
  float none = 0;
  normalise(real, none);
}

// Normalises a column in which each imaginary part is stored below its real part; the first number
// has no imaginary part, nor has the last one of an even count.
void normalise_column(cv::Mat& spectrum, int x) {
  normalise(spectrum.at<float>(0, x));
  for (int y = 1; y + 1 < spectrum.rows; y += 2)
    normalise(spectrum.at<float>(y, x), spectrum.at<float>(y + 1, x));
  if (spectrum.rows % 2 == 0) normalise(spectrum.at<float>(spectrum.rows - 1, x));
}

// Normalises the spectrum of a real image to its phases, packed as by cv::dft().
void keep_phases(cv::Mat& spectrum) {
  normalise_column(spectrum, 0);
  if (spectrum.cols % 2 == 0) normalise_column(spectrum, spectrum.cols - 1);
  for (int y = 0; y < spectrum.rows; ++y) {
    auto* row = spectrum.ptr<float>(y);
    for (int x = 1; x + 1 < spectrum.cols; x += 2) normalise(row[x], row[x + 1]);
  }
}

int wrapped(int place, int size) {
  return (place + size) % size;
}

// Position of the highest value, refined by the centroid around it; within half the size in either
// direction.
cv::Point2d peak_of(const cv::Mat& correlation) {
  cv::Point peak;
  cv::minMaxLoc(correlation, nullptr, nullptr, nullptr, &peak);
  double sum = std::numeric_limits<double>::epsilon();
  cv::Point2d off;
  for (int dy = -kAround; dy <= kAround; ++dy)
    for (int dx = -kAround; dx <= kAround; ++dx) {
      const double value = correlation.at<float>(wrapped(peak.y + dy, correlation.rows),
                                                 wrapped(peak.x + dx, correlation.cols));
      sum += value;
      off += value * cv::Point2d(dx, dy);
    }
  if (2 * peak.x >= correlation.cols) peak.x -= correlation.cols;
  if (2 * peak.y >= correlation.rows) peak.y -= correlation.rows;
  return cv::Point2d(peak) + off / sum;
}

}  // namespace

cv::Point2d phase_shift(const cv::Mat& before, const cv::Mat& after) {
  // A window of one or two pixels is zero.
  if (std::min(before.cols, before.rows) < kSmallest) return {};
  cv::Mat correlation = windowed(before), other = windowed(after);
  cv::dft(correlation, correlation);
  cv::dft(other, other);
  cv::mulSpectrums(correlation, other, correlation, 0, true);
  keep_phases(correlation);
  cv::idft(correlation, correlation);
  return -peak_of(correlation);
}

}  // namespace mbncc::alignment
