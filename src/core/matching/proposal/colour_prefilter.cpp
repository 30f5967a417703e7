// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/colour_prefilter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "imaging/pyramid.hpp"
#include "simd/kernels.hpp"

namespace mbncc::proposal {
namespace {

constexpr int kUnit = ColourPrefilter::kUnit;
constexpr float kMost = 2.5f;    // largest log-odds of one colour
constexpr float kOther = 0.03f;  // fraction of arbitrary other colours on an object

constexpr double kTelling = 0.5;  // least mean log-odds of an object's own colours for prefiltering
constexpr double kEnough = -0.4;  // least mean log-odds of a place
constexpr double kFewest = 0.02, kMostPlaces = 0.2;  // parts of the image that remain

constexpr int kRowStep = 2;  // [cells]: places within one cell of the tested ones remain, too

/// Log-likelihood ratio [1/kUnit] of object to image, per colour class.
std::vector<std::int8_t> compare(const imaging::ColourShares& object,
                                 const imaging::ColourShares& scene) {
  constexpr float kNever = 1e-6f;
  std::vector<std::int8_t> ratios(object.size());
  for (std::size_t i = 0; i < object.size(); ++i) {
    const float ratio =
        ((1 - kOther) * object[i] + kOther * scene[i] + kNever) / (scene[i] + kNever);
    ratios[i] =
        static_cast<std::int8_t>(std::lround(kUnit * std::clamp(std::log(ratio), -kMost, kMost)));
  }
  return ratios;
}

/// Log-likelihood ratios of the classes, summed over cells of `side` pixels: CV_32SC1.
cv::Mat cell_sums(const cv::Mat& classes, const std::vector<std::int8_t>& ratios, int side) {
  cv::Mat cells = cv::Mat::zeros(classes.rows / side, classes.cols / side, CV_32SC1);
  for (int y = 0; y < cells.rows * side; ++y) {
    const auto* row = classes.ptr<std::uint16_t>(y);
    auto* sums = cells.ptr<std::int32_t>(y / side);
    for (int x = 0; x < cells.cols; ++x)
      for (int k = 0; k < side; ++k) sums[x] += ratios[row[x * side + k]];
  }
  return cells;
}

/// Sums of the cells left of each cell in its row, after replicating the border by `margin` cells.
cv::Mat running_sums(const cv::Mat& cells, int margin) {
  cv::Mat sums;
  cv::copyMakeBorder(cells, sums, margin, margin, margin, margin + 1, cv::BORDER_REPLICATE);
  for (int y = 0; y < sums.rows; ++y) {
    auto* row = sums.ptr<std::int32_t>(y);
    std::exclusive_scan(row, row + sums.cols, row, 0);
  }
  return sums;
}

int level_for_width(double mean_width) {
  constexpr double kAcross = 3;  // [px at the level] so that some are not mixed with the background
  const int level = static_cast<int>(std::floor(std::log2(mean_width / kAcross)));
  return std::clamp(level, imaging::ClassImages::kFirst, imaging::ClassImages::kLast);
}

int level_for_area(double area) {
  constexpr double kCells = 25;
  return static_cast<int>(std::floor(0.5 * std::log2(std::max(1.0, area / kCells))));
}

/// Level of cells large enough to limit the number of cells of the object.
int level_for_reach(double reach) {
  constexpr double kMostCells = 256;
  return static_cast<int>(std::ceil(std::log2(std::max(1.0, reach / kMostCells))));
}

/// Upper quantile `part` of values within a range around 0.
int upper_quantile(const cv::Mat& values, double part) {
  constexpr int kRange = 256;
  std::array<int, 2 * kRange> counts{};
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x)
      ++counts[std::clamp(static_cast<int>(values.at<std::int16_t>(y, x)), -kRange, kRange - 1) +
               kRange];
  const double wanted = part * static_cast<double>(values.total());
  int above = 0, value = kRange - 1;
  for (; value > -kRange; --value) {
    above += counts[value + kRange];
    if (above >= wanted) break;
  }
  return value;
}

}  // namespace

ColourPrefilter::ColourPrefilter(const cv::Mat& surface, const cv::Mat& map, cv::Point2d anchor,
                                 double mean_width)
    : class_level_(level_for_width(mean_width)),
      cell_level_(std::max(
          std::clamp(level_for_area(cv::countNonZero(map)), class_level_, class_level_ + 2),
          level_for_reach(std::max(map.cols, map.rows) / 2.0))) {
  constexpr int kRotations = 16;
  const cv::Mat level = imaging::build_pyramid(surface, class_level_).back();
  cv::Mat inside;
  cv::resize(map, inside, level.size(), 0, 0, cv::INTER_AREA);
  const cv::Mat whole = inside >= 250;
  constexpr int kFewPixels = 15;
  shares_ = imaging::colour_shares(imaging::colour_classes(level),
                                   cv::countNonZero(whole) >= kFewPixels ? whole : inside >= 128);
  const TemplateBank bank = turned_maps(map, anchor, cell_level_, kRotations);
  rotations_ = bank.kernels;
  radius_ = bank.radius;
}

/// Mean log-likelihood ratio [1/kUnit] of the cells under the map, the largest over all rotations:
/// CV_16SC1.
cv::Mat ColourPrefilter::best_of_rotations(const cv::Mat& classes,
                                           const LogLikelihoodRatios& ratios) const {
  const int side = 1 << (cell_level_ - class_level_);
  const cv::Mat cells = cell_sums(classes, ratios, side);
  const cv::Mat sums = running_sums(cells, radius_);
  const int stride = sums.cols;
  cv::Mat best(cells.size(), CV_16SC1, cv::Scalar(-kUnit * kMost));
  std::vector<std::int32_t> begins, ends, totals(cells.cols);
  for (const auto& rotation : *rotations_) {
    if (rotation.pixels.empty()) continue;
    begins.clear();
    ends.clear();
    for (const auto& run : rotation.runs) {
      begins.push_back(run.y * stride + run.begin);
      ends.push_back(run.y * stride + run.end);
    }
    const float scale = 1.f / static_cast<float>(side * side * rotation.pixels.size());
    for (int y = 0; y < cells.rows; y += kRowStep) {
      kernels::sum_runs(sums.ptr<std::int32_t>(y + radius_) + radius_, begins.data(), ends.data(),
                        static_cast<int>(begins.size()), totals.data(), cells.cols);
      auto* row = best.ptr<std::int16_t>(y);
      for (int x = 0; x < cells.cols; ++x)
        row[x] = std::max(row[x], static_cast<std::int16_t>(scale * totals[x]));
    }
  }
  return best;
}

ColourPrefilter::LogLikelihoodRatios ColourPrefilter::log_likelihood_ratios(
    const imaging::ClassImages& scene) const {
  return compare(shares_, scene.shares());
}

SearchMask ColourPrefilter::places(const imaging::ClassImages& scene) const {
  if (scene.last_level() < class_level_) return {};
  const cv::Mat& classes = scene.at(class_level_);
  if (std::min(classes.cols, classes.rows) >> (cell_level_ - class_level_) == 0) return {};
  const LogLikelihoodRatios ratios = this->log_likelihood_ratios(scene);
  const double telling =
      std::inner_product(shares_.begin(), shares_.end(), ratios.begin(), 0.0) / kUnit;
  if (telling < kTelling) return {};
  cv::Mat best = best_of_rotations(classes, ratios);
  cv::dilate(best, best, cv::Mat());
  const int enough = std::clamp(cvRound(kUnit * kEnough), upper_quantile(best, kMostPlaces),
                                upper_quantile(best, kFewest));
  return {best >= enough, cell_level_};
}

}  // namespace mbncc::proposal
