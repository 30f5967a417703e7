// SPDX-License-Identifier: BSD-3-Clause
#include "imaging/colour_bins.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace mbncc::imaging {
namespace {

constexpr double kDark = 12;    // [grey levels] added before taking logarithms
constexpr double kReach = 0.6;  // range of ln R/G and ln B/G
constexpr int kFine = 1024;     // units of the tables below per class

/// Logarithms of the channels in units of a class: of chroma, and of brightness per channel.
struct Tables {
  std::array<int, 256> chroma, brightness;

  Tables() {
    const double darkest = std::log(kDark), brightest = std::log(255 + kDark);
    for (int value = 0; value < 256; ++value) {
      const double logarithm = std::log(value + kDark);
      chroma[value] = cvRound(kFine * kChromaClasses * logarithm / (2 * kReach));
      const double relative = (logarithm - darkest) / (brightest - darkest);
      brightness[value] = cvRound(kFine * kBrightnessClasses * relative / 3);
    }
  }
};

/// `value` / kFine, clamped to [0, count).
int clamped(int value, int count) {
  return static_cast<int>(static_cast<unsigned>(std::clamp(value, 0, kFine * count - 1)) / kFine);
}

int class_of(const Tables& tables, const uchar* colour) {
  constexpr int kMiddle = kFine * kChromaClasses / 2;
  const int reference = tables.chroma[colour[1]] - kMiddle;
  const int red = clamped(tables.chroma[colour[2]] - reference, kChromaClasses);
  const int blue = clamped(tables.chroma[colour[0]] - reference, kChromaClasses);
  const int brightness = clamped(
      tables.brightness[colour[0]] + tables.brightness[colour[1]] + tables.brightness[colour[2]],
      kBrightnessClasses);
  return (red * kChromaClasses + blue) * kBrightnessClasses + brightness;
}

/// Smooths the shares along one dimension: `count` classes, `stride` apart. Nothing is lost at the
/// ends.
void blur(ColourShares& shares, int count, int stride, double sigma) {
  constexpr int kWidest = 4;
  std::array<float, kWidest + 1> weights{};
  float total = 0;
  for (int k = 0; k <= kWidest; ++k) {
    weights[k] = static_cast<float>(std::exp(-0.5 * k * k / (sigma * sigma)));
    total += k == 0 ? weights[k] : 2 * weights[k];
  }
  ColourShares blurred(shares.size(), 0.f);
  for (int i = 0; i < static_cast<int>(shares.size()); ++i) {
    if (shares[i] == 0) continue;
    const int at = i / stride % count;
    for (int k = -kWidest; k <= kWidest; ++k) {
      const int to = std::clamp(at + k, 0, count - 1);
      blurred[i + (to - at) * stride] += shares[i] * weights[std::abs(k)] / total;
    }
  }
  shares = std::move(blurred);
}

}  // namespace

cv::Mat colour_classes(const cv::Mat& image) {
  static const Tables tables;
  cv::Mat classes(image.size(), CV_16UC1);
  for (int y = 0; y < image.rows; ++y) {
    const uchar* colours = image.ptr(y);
    auto* row = classes.ptr<std::uint16_t>(y);
    for (int x = 0; x < image.cols; ++x)
      row[x] = static_cast<std::uint16_t>(class_of(tables, colours + 3 * x));
  }
  return classes;
}

ColourShares colour_shares(const cv::Mat& classes, const cv::Mat& mask) {
  constexpr double kChromaBlur = 1.2, kBrightnessBlur = 0.8;  // [classes]
  // Neighbours are often of the same class; interleaved counters avoid dependent additions.
  std::array<std::vector<int>, 4> counts;
  for (auto& part : counts) part.assign(kColourClasses, 0);
  for (int y = 0; y < classes.rows; ++y) {
    const auto* row = classes.ptr<std::uint16_t>(y);
    const uchar* wanted = mask.empty() ? nullptr : mask.ptr(y);
    for (int x = 0; x < classes.cols; ++x)
      if (wanted == nullptr || wanted[x] != 0) ++counts[x % counts.size()][row[x]];
  }
  ColourShares shares(kColourClasses, 0.f);
  for (const auto& part : counts)
    std::transform(part.begin(), part.end(), shares.begin(), shares.begin(),
                   [](int count, float share) { return share + static_cast<float>(count); });
  const float total = std::accumulate(shares.begin(), shares.end(), 0.f);
  for (auto& share : shares) share /= std::max(1.f, total);
  blur(shares, kChromaClasses, kChromaClasses * kBrightnessClasses, kChromaBlur);
  blur(shares, kChromaClasses, kBrightnessClasses, kChromaBlur);
  blur(shares, kBrightnessClasses, 1, kBrightnessBlur);
  return shares;
}

ClassImages::ClassImages(const std::vector<cv::Mat>& pyramid) {
  for (int level = kFirst; level <= kLast && level < static_cast<int>(pyramid.size()); ++level)
    levels_.push_back(colour_classes(pyramid[level]));
  if (!levels_.empty()) shares_ = colour_shares(levels_.front());
}

}  // namespace mbncc::imaging
