// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/polar.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "mbncc/geometry.hpp"
#include "simd/kernels.hpp"

namespace mbncc {
namespace {

constexpr double kNoiseVariance = 16;  // [grey^2] see similarity.hpp

cv::Point2d at(cv::Point2d centre, double radius, double angle) {
  return centre + radius * cv::Point2d(std::cos(angle), std::sin(angle));
}

void sampling_maps(cv::Point2d centre, const PolarGrid& grid, cv::Mat& x, cv::Mat& y) {
  x.create(grid.rings, grid.angles, CV_32FC1);
  y.create(grid.rings, grid.angles, CV_32FC1);
  for (int ring = 0; ring < grid.rings; ++ring) {
    for (int column = 0; column < grid.angles; ++column) {
      const cv::Point2d point = at(centre, grid.ring_radius(ring), 2 * kPi * column / grid.angles);
      x.at<float>(ring, column) = static_cast<float>(point.x);
      y.at<float>(ring, column) = static_cast<float>(point.y);
    }
  }
}

/// True when all four pixels that a bilinear reading at `point` touches lie in the region.
bool touches_only(const cv::Mat& region, cv::Point2d point) {
  const int x = static_cast<int>(std::floor(point.x)), y = static_cast<int>(std::floor(point.y));
  if (x < 0 || y < 0 || x + 1 >= region.cols || y + 1 >= region.rows) return false;
  return region.at<uchar>(y, x) != 0 && region.at<uchar>(y, x + 1) != 0 &&
         region.at<uchar>(y + 1, x) != 0 && region.at<uchar>(y + 1, x + 1) != 0;
}

/// Dot products of a ring's weights with the target's ring at consecutive shifts, added up over
/// rings.
class ShiftedSums {
 public:
  ShiftedSums(int angles, int first, int count)
      : angles_(angles),
        first_(((first % angles) + angles) % angles),
        count_(count),
        values_(angles + count),
        squares_(angles + count),
        dots_(count),
        products(count, 0),
        sums(count, 0),
        squares(count, 0) {}

  void add(const float* target, const float* weighted, const float* weights) {
    for (int j = 0; j < angles_ + count_; ++j) {
      values_[j] = target[(first_ + j) % angles_];
      squares_[j] = values_[j] * values_[j];
    }
    add_dots(values_, weighted, products);
    add_dots(values_, weights, sums);
    add_dots(squares_, weights, squares);
  }

 private:
  void add_dots(const std::vector<float>& ring, const float* weights, std::vector<double>& totals) {
    kernels::dots(ring.data(), 1, count_, weights, angles_, dots_.data());
    for (int k = 0; k < count_; ++k) totals[k] += dots_[k];
  }

  int angles_, first_, count_;
  std::vector<float> values_, squares_, dots_;

 public:
  std::vector<double> products, sums, squares;  ///< per shift
};

}  // namespace

PolarGrid PolarGrid::of(double radius) {
  constexpr int kStep = 16;
  const int rings = std::max(2, static_cast<int>(std::ceil(radius)));
  const int angles = static_cast<int>(std::ceil(2 * kPi * radius / kStep)) * kStep;
  return {radius, rings, std::max(2 * kStep, angles)};
}

PolarImage polar_image(const cv::Mat& image, cv::Point2d centre, const PolarGrid& grid) {
  if (image.type() != CV_8UC1 && image.type() != CV_32FC1)
    throw std::invalid_argument("a polar image is made of a grey image");
  cv::Mat source, x, y;
  image.convertTo(source, CV_32F);
  sampling_maps(centre, grid, x, y);
  PolarImage polar{grid, {}};
  cv::remap(source, polar.values, x, y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  return polar;
}

PolarTemplate::PolarTemplate(const cv::Mat& image, const cv::Mat& region, cv::Point2d centre,
                             const PolarGrid& grid)
    : grid_(grid), used_(grid.rings, 0) {
  if (region.type() != CV_8UC1 || region.size() != image.size())
    throw std::invalid_argument("a polar template needs a region of its image's size");
  const cv::Mat values = polar_image(image, centre, grid).values;
  double sum = 0;
  for (int ring = 0; ring < grid.rings; ++ring) {
    const double radius = grid.ring_radius(ring);
    for (int column = 0; column < grid.angles; ++column) {
      const bool inside = touches_only(region, at(centre, radius, 2 * kPi * column / grid.angles));
      weights_.push_back(inside ? static_cast<float>(radius) : 0.f);
      if (inside) used_[ring] = 1;
      total_weight_ += weights_.back();
      sum += weights_.back() * values.at<float>(ring, column);
    }
  }
  const double mean = total_weight_ > 0 ? sum / total_weight_ : 0;
  for (int i = 0; i < grid.rings * grid.angles; ++i) {
    const double difference = values.at<float>(i / grid.angles, i % grid.angles) - mean;
    weighted_.push_back(static_cast<float>(weights_[i] * difference));
    energy_ += weights_[i] * difference * difference;
  }
}

std::vector<double> PolarTemplate::similarities(const PolarImage& target, int first,
                                                int count) const {
  const int angles = grid_.angles;
  if (target.values.rows != grid_.rings || target.values.cols != angles)
    throw std::invalid_argument("a polar target needs its template's grid");
  ShiftedSums totals(angles, first, count);
  for (int ring = 0; ring < grid_.rings; ++ring) {
    const std::size_t start = static_cast<std::size_t>(ring) * angles;
    if (used_[ring])
      totals.add(target.values.ptr<float>(ring), &weighted_[start], &weights_[start]);
  }
  std::vector<double> result(count, 0);
  if (total_weight_ <= 0) return result;
  const double noise = kNoiseVariance * total_weight_;
  for (int k = 0; k < count; ++k) {
    const double mean = totals.sums[k] / total_weight_;
    const double energy = std::max(0.0, totals.squares[k] - mean * totals.sums[k]);
    result[k] = totals.products[k] / std::sqrt((energy + noise) * (energy_ + noise));
  }
  return result;
}

}  // namespace mbncc
