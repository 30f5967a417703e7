// SPDX-License-Identifier: BSD-3-Clause
#include "matching/prepared/self_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/imgproc.hpp>

namespace mbncc::prepared {
namespace {

constexpr double kRadius = 48;             // [px] larger objects are compared at this size
constexpr int kMargin = 4;                 // [px] of the canvas around the object
constexpr double kSmoothing = 0.6;         // [px of the canvas] before anything is compared
constexpr double kEdgeHeight = 60;         // [grey levels] weight of the outline in the alignment
constexpr double kRim = 0.08;              // of the radius: bevels and mixed pixels
constexpr double kMisaligned = 0.5;        // [px of the canvas] tolerated misalignment, ...
constexpr double kSmallMisaligned = 0.02;  // [radii] ... limited for small objects
constexpr double kMostNoise = 3;           // [grey levels] stronger fine structure is texture
constexpr double kMarkWidth = 0.03;        // of the radius
constexpr double kMarkArea = 0.005;        // of the map: least area of a mark

/// The value that the upper `part` of the values under the mask exceeds.
double upper_quantile(const cv::Mat& values, const cv::Mat& mask, double part) {
  std::vector<float> found;
  for (int y = 0; y < values.rows; ++y)
    for (int x = 0; x < values.cols; ++x)
      if (mask.at<uchar>(y, x) != 0) found.push_back(values.at<float>(y, x));
  if (found.empty()) return 0;
  const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(found.size()));
  std::nth_element(found.begin(), found.begin() + at, found.end(), std::greater<>());
  return found[static_cast<std::size_t>(at)];
}

double mean_square(const cv::Mat& values, const cv::Mat& mask) {
  return cv::mean(values.mul(values), mask)[0];
}

cv::Mat distance_inside(const cv::Mat& map) {
  cv::Mat distance;
  cv::distanceTransform(map, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return distance;
}

std::array<cv::Mat, 2> gradient(const cv::Mat& values) {
  std::array<cv::Mat, 2> by;
  cv::Sobel(values, by[0], CV_32F, 1, 0, 3, 0.125);
  cv::Sobel(values, by[1], CV_32F, 0, 1, 3, 0.125);
  return by;
}

/// [grey levels] largest change by a displacement of `distance` [px].
cv::Mat change_by_displacement(const cv::Mat& values, double distance) {
  const auto by = gradient(values);
  cv::Mat slope;
  cv::magnitude(by[0], by[1], slope);
  cv::dilate(slope, slope, cv::getStructuringElement(cv::MORPH_RECT, {3, 3}));
  return distance * slope;
}

/// Soft threshold: moves the values towards 0 by `by`.
cv::Mat shrunk(const cv::Mat& values, const cv::Mat& by) {
  const cv::Mat above = cv::max(values - by, 0), below = cv::min(values + by, 0);
  return above + below;
}

/// [grey levels] standard deviation of the finest structure (Immerkaer 1996), from its median.
double noise_of(const View& view) {
  cv::Mat grey, fine;
  cv::cvtColor(view.template_image, grey, cv::COLOR_BGR2GRAY);
  const cv::Mat kernel = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::filter2D(grey, fine, CV_32F, kernel);
  constexpr double kNormalMedian = 0.6745;
  return upper_quantile(cv::abs(fine), view.map, 0.5) / (cv::norm(kernel) * kNormalMedian);
}

/// Fraction of the standard deviation of white noise that remains after a Gaussian filter of
/// `width` [px].
double passed_by(double width) {
  return 1 / (2 * std::sqrt(kPi) * width);
}

}  // namespace

CentredMap::CentredMap(const View& view) : centre_(centroid(view.map)) {
  radius_ = std::max(radius_, farthest_pixel(view.map, centre_));
  scale_ = std::min(1.0, kRadius / radius_);
  const int half = static_cast<int>(std::ceil(scale_ * radius_)) + kMargin;
  map_ = cv::Mat(2 * half + 1, 2 * half + 1, CV_8UC1);
  cv::warpAffine(view.map, map_, to_view(0), map_.size(), cv::INTER_LINEAR | cv::WARP_INVERSE_MAP);
  map_ = map_ > 127;
  cv::findNonZero(map_, points_);
}

cv::Matx23d CentredMap::to_view(double angle, cv::Vec2d shift) const {
  const double c = std::cos(angle) / scale_, s = std::sin(angle) / scale_;
  const double half = map_.cols / 2;  // whole pixels
  return {c, -s, centre_.x + shift[0] / scale_ - c * half + s * half,
          s, c,  centre_.y + shift[1] / scale_ - s * half - c * half};
}

double CentredMap::overlap(double angle) const {
  const double c = std::cos(angle), s = std::sin(angle);
  const int half = map_.cols / 2;
  int common = 0;
  for (const auto& point : points_) {
    const double x = point.x - half, y = point.y - half;
    const cv::Point at(cvRound(half + c * x - s * y), cvRound(half + s * x + c * y));
    common += cv::Rect({0, 0}, map_.size()).contains(at) && map_.at<uchar>(at) != 0;
  }
  return points_.empty() ? 0 : common / area();
}

SelfComparison::SelfComparison(const View& view, const CentredMap& map)
    : map_(map), noise_(std::min(noise_of(view), kMostNoise)) {
  cv::Mat colours, coverage;
  view.template_image.convertTo(colours, CV_32F);
  view.map.convertTo(coverage, CV_32F, kEdgeHeight / 255);
  const int from_to[] = {0, 0, 1, 1, 2, 2, 3, 3};
  source_.create(view.map.size(), CV_32FC4);
  const cv::Mat sources[] = {coverage, colours};
  cv::mixChannels(sources, 2, &source_, 1, from_to, kPlanes);
  cv::GaussianBlur(source_, source_, {}, kSmoothing / map_.scale());
  own_ = sampled(0, {});

  inside_ = distance_inside(map_.map());
  outside_ = distance_inside(~map_.map());
  inner_ = inside_ > std::max(1.5, kRim * map_.scale() * map_.radius());
  if (4 * cv::countNonZero(inner_) < map_.area()) inner_ = map_.map();
  make_basis();
  make_slopes();
  const double misalignment =
      std::min(kMisaligned, kSmallMisaligned * map_.scale() * map_.radius());
  double squares = 0;
  for (int plane = 1; plane < kPlanes; ++plane) {
    squares += mean_square(without_shading(own_[plane]), inner_);
    misaligned_[plane] = change_by_displacement(own_[plane], misalignment);
  }
  texture_ = std::sqrt(squares / (kPlanes - 1));
}

// Models the light by polynomials of the position.
void SelfComparison::make_basis() {
  constexpr int kOrder = 3;
  const int half = inner_.cols / 2;
  for (int total = 0; total <= kOrder; ++total)
    for (int power = 0; power <= total; ++power) {
      cv::Mat values(inner_.size(), CV_32FC1);
      for (int y = 0; y < values.rows; ++y)
        for (int x = 0; x < values.cols; ++x)
          values.at<float>(y, x) =
              static_cast<float>(std::pow((x - half) / kRadius, total - power) *
                                 std::pow((y - half) / kRadius, power));
      values = without_shading(values);
      const double norm = cv::norm(values);
      if (norm > 1e-3) basis_.push_back(values / norm);
    }
}

void SelfComparison::make_slopes() {
  constexpr double kDamping = 1;
  hessian_ = kDamping * cv::Matx22d::eye();
  for (int plane = 0; plane < kPlanes; ++plane) {
    auto by = gradient(own_[plane]);
    for (auto& slope : by)
      if (plane > 0) slope.setTo(0, ~inner_);
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k) hessian_(i, k) += by[i].dot(by[k]);
    for (int i = 0; i < 2; ++i) slopes_[i][plane] = by[i];
  }
}

SelfComparison::Planes SelfComparison::sampled(double angle, cv::Vec2d shift) const {
  cv::Mat all;
  cv::warpAffine(source_, all, map_.to_view(angle, shift), map_.map().size(),
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar::all(0));
  Planes planes;
  cv::split(all, planes.data());
  return planes;
}

// Inverse compositional Gauss-Newton (Baker and Matthews 2004) of a shift.
cv::Vec2d SelfComparison::best_shift(double angle) const {
  constexpr int kIterations = 4;
  constexpr double kSmallStep = 0.05;  // [px]
  const double farthest = 0.1 * map_.scale() * map_.radius();
  const cv::Matx22d turn(std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle));
  cv::Vec2d shift;
  for (int k = 0; k < kIterations; ++k) {
    const Planes turned = sampled(angle, shift);
    cv::Vec2d pull;
    for (int plane = 0; plane < kPlanes; ++plane) {
      cv::Mat difference = turned[plane] - own_[plane];
      if (plane > 0) difference -= cv::mean(difference, inner_)[0];
      for (int i = 0; i < 2; ++i) pull[i] += slopes_[i][plane].dot(difference);
    }
    const cv::Vec2d step = hessian_.inv() * pull;
    shift -= turn * step;
    shift *= std::min(1.0, farthest / std::max(cv::norm(shift), 1e-9));
    if (cv::norm(step) < kSmallStep) break;
  }
  return shift;
}

cv::Mat SelfComparison::without_shading(const cv::Mat& values) const {
  cv::Mat left = values.clone();
  left.setTo(0, ~inner_);
  for (const auto& function : basis_) cv::scaleAdd(function, -left.dot(function), left, left);
  return left;
}

TurnDifference SelfComparison::difference(double angle) const {
  const Planes turned = sampled(angle, best_shift(angle));
  const cv::Mat turned_map = turned[0] > kEdgeHeight / 2;
  TurnDifference result;
  compare_outlines(turned_map, result);
  compare_surfaces(turned, turned_map, result);
  return result;
}

void SelfComparison::compare_outlines(const cv::Mat& turned_map, TurnDifference& difference) const {
  const cv::Mat& map = map_.map();
  difference.overlap = cv::countNonZero(turned_map & map) / map_.area();
  double missing = 0, added = 0;
  cv::minMaxLoc(inside_, nullptr, &missing, nullptr, nullptr, map & ~turned_map);
  cv::minMaxLoc(outside_, nullptr, &added, nullptr, nullptr, turned_map & ~map);
  difference.outline = std::max(missing, added) / map_.scale();
}

void SelfComparison::compare_surfaces(const Planes& turned, const cv::Mat& turned_map,
                                      TurnDifference& difference) const {
  const cv::Mat both = inner_ & (distance_inside(turned_map) > 1);
  const double width = std::max(1.0, kMarkWidth * map_.scale() * map_.radius());
  cv::Mat weight, strongest = cv::Mat::zeros(both.size(), CV_32FC1);
  both.convertTo(weight, CV_32F, 1.0 / 255);
  cv::GaussianBlur(weight, weight, {}, width);
  double squares = 0;
  for (int plane = 1; plane < kPlanes; ++plane) {
    cv::Mat left = shrunk(without_shading(turned[plane] - own_[plane]), misaligned_[plane]);
    left.setTo(0, ~both);
    squares += mean_square(left, both);
    cv::GaussianBlur(left, left, {}, width);
    strongest = cv::max(strongest, cv::abs(left) / (weight + 1e-3));
  }
  difference.rest = std::sqrt(squares / (kPlanes - 1));
  difference.mark = upper_quantile(strongest, both, kMarkArea);
}

double SelfComparison::noise_of_mark() const {
  constexpr double kStrongest = 3;  // [standard deviations] of the largest over map and channels
  const double width = std::max(1.0, kMarkWidth * map_.scale() * map_.radius());
  return kStrongest * std::sqrt(2) * noise_ *
         passed_by(std::hypot(kSmoothing, width) / map_.scale());
}

}  // namespace mbncc::prepared
