// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/superpixels.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/seeds.hpp>
#include <opencv2/ximgproc/slic.hpp>
#include <stdexcept>
#include <vector>

namespace mbncc {
namespace {

// SEEDS: two block levels over pixels, smoothness prior 2, 5 bins per Lab channel, and four passes,
// after which the cells hardly change.
constexpr int kLevels = 2;
constexpr int kPrior = 2;
constexpr int kHistogramBins = 5;
constexpr int kPasses = 4;
constexpr int kSmallestCell = 16;  // [px]
constexpr int kSmallestSide = 64;  // [px] SEEDS reads beyond its blocks on smaller images
constexpr int kFewestAcross = 4;   // cells along the shorter side, for the same reason

// SLIC: its authors' compactness, ten passes as they recommend, no fewer than 4 pixels a side.
constexpr float kCompactness = 10;
constexpr int kSlicPasses = 10;
constexpr int kSmallestSlicSide = 4;  // [px]

void require_usable(const cv::Mat& image) {
  if (image.type() != CV_8UC3 || image.rows < 8 || image.cols < 8)
    throw std::invalid_argument("superpixels need a colour image of at least 8 x 8");
}

cv::Mat padded_for_seeds(const cv::Mat& image) {
  cv::Mat padded;
  cv::copyMakeBorder(image, padded, 0, std::max(0, kSmallestSide - image.rows), 0,
                     std::max(0, kSmallestSide - image.cols), cv::BORDER_REPLICATE);
  return padded;
}

int seeds_count(const cv::Size& size, int wanted) {
  const double aspect =
      std::max(size.width, size.height) / static_cast<double>(std::min(size.width, size.height));
  const int fewest = static_cast<int>(kFewestAcross * kFewestAcross * aspect) + 1;
  return std::clamp(wanted, fewest, std::max(fewest, size.area() / kSmallestCell));
}

}  // namespace

Superpixels seeds_superpixels(const cv::Mat& image, int wanted) {
  require_usable(image);
  const cv::Mat padded = padded_for_seeds(image);
  cv::Mat lab;
  cv::cvtColor(padded, lab, cv::COLOR_BGR2Lab);
  const auto seeds = cv::ximgproc::createSuperpixelSEEDS(padded.cols, padded.rows, 3,
                                                         seeds_count(padded.size(), wanted),
                                                         kLevels, kPrior, kHistogramBins);
  seeds->iterate(lab, kPasses);
  Superpixels result;
  seeds->getLabels(result.labels);
  result.labels = result.labels(cv::Rect({0, 0}, image.size())).clone();
  result.count = seeds->getNumberOfSuperpixels();
  return result;
}

Superpixels slic_superpixels(const cv::Mat& image, int wanted) {
  require_usable(image);
  cv::Mat lab;
  cv::cvtColor(image, lab, cv::COLOR_BGR2Lab);
  const int side =
      static_cast<int>(std::lround(std::sqrt(image.total() / std::max(1., 1. * wanted))));
  const auto slic = cv::ximgproc::createSuperpixelSLIC(
      lab, cv::ximgproc::SLIC,
      std::clamp(side, kSmallestSlicSide, std::min(image.rows, image.cols) / 2), kCompactness);
  slic->iterate(kSlicPasses);
  Superpixels result;
  slic->getLabels(result.labels);
  result.count = slic->getNumberOfSuperpixels();
  return result;
}

Superpixels superpixels_of(const cv::Mat& image, const std::string& method, int wanted) {
  if (method == "seeds") return seeds_superpixels(image, wanted);
  if (method == "slic") return slic_superpixels(image, wanted);
  throw std::invalid_argument("unknown superpixels '" + method + "'");
}

cv::Mat simplify_superpixels(const cv::Mat& image, const Superpixels& superpixels) {
  std::vector<cv::Vec4d> sums(superpixels.count, cv::Vec4d::all(0));
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x) {
      const auto& colour = image.at<cv::Vec3b>(y, x);
      sums[superpixels.labels.at<int>(y, x)] += cv::Vec4d(colour[0], colour[1], colour[2], 1);
    }
  std::vector<cv::Vec3b> means(sums.size());
  std::transform(sums.begin(), sums.end(), means.begin(), [](const cv::Vec4d& sum) {
    const double n = std::max(1.0, sum[3]);
    return cv::Vec3b(cv::saturate_cast<uchar>(sum[0] / n), cv::saturate_cast<uchar>(sum[1] / n),
                     cv::saturate_cast<uchar>(sum[2] / n));
  });
  cv::Mat simplified(image.size(), CV_8UC3);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      simplified.at<cv::Vec3b>(y, x) = means[superpixels.labels.at<int>(y, x)];
  return simplified;
}

cv::Mat superpixels_inside(const Superpixels& superpixels, const cv::Mat& region) {
  std::vector<int> balance(superpixels.count, 0);  // pixels inside minus pixels outside
  for (int y = 0; y < region.rows; ++y)
    for (int x = 0; x < region.cols; ++x)
      balance[superpixels.labels.at<int>(y, x)] += region.at<uchar>(y, x) ? 1 : -1;
  cv::Mat inside(region.size(), CV_8UC1);
  for (int y = 0; y < region.rows; ++y)
    for (int x = 0; x < region.cols; ++x)
      inside.at<uchar>(y, x) = balance[superpixels.labels.at<int>(y, x)] > 0 ? 255 : 0;
  return inside;
}

}  // namespace mbncc
