// SPDX-License-Identifier: BSD-3-Clause
#include "matching/masked_template_engine.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "matching/suppression.hpp"

namespace mbncc::bench {
namespace {

constexpr int kTopLevel = 2;            // three levels: 0, 1, 2
constexpr double kLeastDiameter = 12;   // [px] at the coarse level; smaller templates do not work
constexpr std::size_t kKeptPeaks = 20;  // coarse peaks that are refined
constexpr int kSearchReach = 2;         // [px] around a peak, at the next finer level
constexpr double kArcStep = 1.5;        // [px] along the excircle between two rotations

double similarity_or_nothing(double value) {
  return std::isfinite(value) && std::abs(value) <= 1.001 ? value : -1;
}

/// Masked NCC at every position where the template fits in; flat positions, where OpenCV divides by
/// zero, get -1.
cv::Mat similarities(const cv::Mat& image, const cv::Mat& template_image, const cv::Mat& mask) {
  cv::Mat result;
  cv::matchTemplate(image, template_image, result, cv::TM_CCOEFF_NORMED, mask);
  result.forEach<float>(
      [](float& value, const int*) { value = static_cast<float>(similarity_or_nothing(value)); });
  return result;
}

/// Vertex of the parabola through (-1, left), (0, middle), (1, right).
double vertex(double left, double middle, double right) {
  const double bend = left - 2 * middle + right;
  return bend < 0 ? std::clamp(0.5 * (left - right) / bend, -0.5, 0.5) : 0;
}

cv::Point2d subpixel(const cv::Mat& scores, cv::Point at) {
  const auto value = [&](int x, int y) {
    return scores.at<float>(std::clamp(y, 0, scores.rows - 1), std::clamp(x, 0, scores.cols - 1));
  };
  const double middle = value(at.x, at.y);
  return {at.x + vertex(value(at.x - 1, at.y), middle, value(at.x + 1, at.y)),
          at.y + vertex(value(at.x, at.y - 1), middle, value(at.x, at.y + 1))};
}

cv::Mat level_of(const cv::Mat& image, int level) {
  cv::Mat result = image;
  for (int i = 0; i < level; ++i) cv::pyrDown(result, result);
  return result;
}

cv::Mat grey_of(const cv::Mat& image) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace

void MaskedTemplateEngine::teach(const cv::Mat& image, const cv::Mat& map, cv::Point2d reference) {
  template_ = grey_of(image);
  mask_ = map.clone();
  const Circle circle = excircle(map);
  radius_ = circle.radius;
  lever_ = reference - circle.centre;
  const int side = 2 * static_cast<int>(std::ceil(radius_ + 4)) + 1;
  const cv::Matx23d shift(1, 0, side / 2 - circle.centre.x, 0, 1, side / 2 - circle.centre.y);
  cv::warpAffine(template_, template_, shift, {side, side}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::warpAffine(mask_, mask_, shift, {side, side}, cv::INTER_NEAREST);
  coarse_level_ = kTopLevel;
  while (coarse_level_ > 0 && 2 * radius_ / (1 << coarse_level_) < kLeastDiameter) --coarse_level_;
  coarse_.clear();
  for (double theta = -kPi; theta < kPi; theta += angle_step(coarse_level_))
    coarse_.push_back(rotated(coarse_level_, theta));
}

double MaskedTemplateEngine::angle_step(int level) const {
  return kArcStep / std::max(2.0, radius_ / (1 << level));
}

MaskedTemplateEngine::Rotated MaskedTemplateEngine::rotated(int level, double theta) const {
  const int scale = 1 << level;
  const int half = static_cast<int>(std::ceil(radius_ / scale)) + 1, side = 2 * half + 1;
  const cv::Mat source = level_of(template_, level), mask = level_of(mask_, level);
  const double centre = static_cast<double>(template_.cols / 2) / scale;
  const double c = std::cos(theta), s = std::sin(theta);
  const cv::Matx23d turn(c, -s, half - c * centre + s * centre, s, c,
                         half - s * centre - c * centre);
  Rotated result;
  result.theta = theta;
  cv::warpAffine(source, result.template_image, turn, {side, side}, cv::INTER_LINEAR,
                 cv::BORDER_REPLICATE);
  cv::warpAffine(mask, result.mask, turn, {side, side}, cv::INTER_LINEAR);
  result.mask = result.mask > 127;
  return result;
}

std::vector<MaskedTemplateEngine::Peak> MaskedTemplateEngine::coarse_peaks(
    const cv::Mat& image) const {
  cv::Mat best, index;
  for (std::size_t i = 0; i < coarse_.size(); ++i) {
    const cv::Mat scores = similarities(image, coarse_[i].template_image, coarse_[i].mask);
    if (best.empty()) {
      best = cv::Mat(scores.size(), CV_32F, cv::Scalar(-2));
      index = cv::Mat(scores.size(), CV_32S);
    }
    const cv::Mat better = scores > best;
    scores.copyTo(best, better);
    index.setTo(static_cast<int>(i), better);
  }
  std::vector<Peak> peaks;
  const int apart = std::max(1, static_cast<int>(radius_ / (1 << coarse_level_) / 2));
  while (peaks.size() < kKeptPeaks) {
    double score = 0;
    cv::Point at;
    cv::minMaxLoc(best, nullptr, &score, nullptr, &at);
    if (score <= 0) break;
    const auto& kernel = coarse_[static_cast<std::size_t>(index.at<int>(at))];
    const cv::Point half(kernel.mask.cols / 2, kernel.mask.rows / 2);
    peaks.push_back({cv::Point2d(at + half), kernel.theta, score});
    cv::circle(best, at, apart, cv::Scalar(-2), cv::FILLED);
  }
  return peaks;
}

MaskedTemplateEngine::Peak MaskedTemplateEngine::refined(const cv::Mat& image, int level,
                                                         const Peak& peak) const {
  const double step = angle_step(level);
  Peak best{peak.position, peak.theta, -1};
  std::vector<double> by_angle;
  int best_angle = 0;
  for (int turn = -3; turn <= 3; ++turn) {
    const Rotated kernel = rotated(level, peak.theta + turn * step);
    const int half = kernel.mask.cols / 2, reach = half + kSearchReach;
    const cv::Point centre(cvRound(peak.position.x), cvRound(peak.position.y));
    const cv::Rect window =
        cv::Rect(centre.x - reach, centre.y - reach, 2 * reach + 1, 2 * reach + 1) &
        cv::Rect({0, 0}, image.size());
    by_angle.push_back(-1);
    if (window.width < kernel.mask.cols || window.height < kernel.mask.rows) continue;
    const cv::Mat scores = similarities(image(window), kernel.template_image, kernel.mask);
    cv::Point at;
    cv::minMaxLoc(scores, nullptr, &by_angle.back(), nullptr, &at);
    if (by_angle.back() <= best.score) continue;
    best_angle = turn;
    best = {subpixel(scores, at) + cv::Point2d(window.x + half, window.y + half), kernel.theta,
            by_angle.back()};
  }
  if (std::abs(best_angle) < 3) {
    const auto middle = static_cast<std::size_t>(best_angle + 3);
    best.theta += step * vertex(by_angle[middle - 1], by_angle[middle], by_angle[middle + 1]);
  }
  return best;
}

std::vector<Found> MaskedTemplateEngine::find(const cv::Mat& image) {
  const cv::Mat grey = grey_of(image);
  const cv::Mat coarse = level_of(grey, coarse_level_);
  if (coarse.cols < coarse_[0].mask.cols || coarse.rows < coarse_[0].mask.rows) return {};
  std::vector<Peak> peaks = coarse_peaks(coarse);
  for (int level = std::max(0, coarse_level_ - 1); level >= 0; --level) {
    const cv::Mat finer = level_of(grey, level);
    for (auto& peak : peaks) {
      if (level < coarse_level_) peak.position *= 2;
      peak = refined(finer, level, peak);
    }
  }
  std::vector<Found> found;
  for (const auto& peak : peaks) {
    if (peak.score <= 0) continue;
    const Pose2D centre{peak.position.x, peak.position.y, wrap_angle(peak.theta)};
    const cv::Point2d reference = transform(centre, lever_);
    found.push_back({{reference.x, reference.y, centre.theta}, peak.score, false, {}});
  }
  return without_neighbours(std::move(found), radius_ / 2);
}

}  // namespace mbncc::bench
