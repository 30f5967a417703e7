// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "sim/drawing.hpp"
#include "sim/random.hpp"
#include "sim/texture.hpp"

namespace mbncc::sim {
namespace {

// Sizes in px, along the arm backwards from the grip point.
constexpr double kScale = 2;        // drawing pixels per image pixel
constexpr double kFingerTip = 12;   // the fingers extend beyond the grip point
constexpr double kFingerBase = 58;  // where the palm begins
constexpr double kFingerWidth = 16;
constexpr double kPalmEnd = 92;  // where the tube begins
constexpr double kPalmHalf = 62;
constexpr double kTubeHalf = 48;
constexpr double kWristHalf = 27;
constexpr double kTaper = 0.25;  // half width gained per px of length
constexpr double kLength = 1400;

Drawing blank(cv::Point2d low, cv::Point2d high) {
  Drawing drawing;
  drawing.scale = kScale;
  const cv::Size size(cvCeil((high.x - low.x) * kScale), cvCeil((high.y - low.y) * kScale));
  drawing.origin = -low * kScale;
  drawing.colour = cv::Mat::zeros(size, CV_32FC3);
  drawing.cover = cv::Mat::zeros(size, CV_32FC1);
  return drawing;
}

/// Brightness of a metal tube across its width, u in [-1, 1]: an off-centre highlight, dark rims.
double tube_shade(double u) {
  const double highlight = std::exp(-std::pow((u + 0.25) / 0.22, 2.0));
  return 70 + 75 * std::sqrt(std::max(0.0, 1 - u * u)) + 70 * highlight;
}

void draw_tube(Drawing& drawing) {
  for (int row = 0; row < drawing.cover.rows; ++row) {
    const double y = (row - drawing.origin.y) / kScale;
    for (int column = 0; column < drawing.cover.cols; ++column) {
      const double distance = (drawing.origin.x - column) / kScale - kPalmEnd;
      const double half = std::min(kTubeHalf, kWristHalf + kTaper * distance);
      if (distance < 0 || std::abs(y) > half) continue;
      const double shade = tube_shade(y / half);
      drawing.cover.at<float>(row, column) = 1;
      drawing.colour.at<cv::Vec3f>(row, column) = cv::Vec3d(shade, shade, 0.97 * shade);
    }
  }
}

/// Fills the box between two corners, in px relative to the origin of the thing.
void fill_box(Drawing& drawing, cv::Point2d low, cv::Point2d high, double grey) {
  const cv::Rect box(cv::Point(drawing.origin + low * kScale),
                     cv::Point(drawing.origin + high * kScale));
  cv::rectangle(drawing.cover, box, cv::Scalar(1), cv::FILLED);
  cv::rectangle(drawing.colour, box, cv::Scalar::all(grey), cv::FILLED);
}

/// Draws dark rings where the links of the tube meet.
void draw_rings(Drawing& drawing) {
  for (double at = 140; at < kLength; at += 170) {
    const int first = cvRound(drawing.origin.x - (at + 9) * kScale);
    const int last = cvRound(drawing.origin.x - at * kScale);
    const cv::Range ring(std::max(0, first), std::max(0, last));
    if (!ring.empty()) drawing.colour.colRange(ring) *= 0.55;
  }
}

/// Adds the grey noise of brushed metal to the covered pixels.
void add_wear(Drawing& drawing) {
  cv::RNG random = generator(1, 4);
  const cv::Mat wear = fractal_noise(drawing.cover.size(), 64, 2, random).mul(drawing.cover, 5.0);
  cv::Mat grey;
  cv::merge(std::vector<cv::Mat>(3, wear), grey);
  drawing.colour += grey;
}

}  // namespace

Drawing draw_arm_body() {
  Drawing drawing = blank({-kLength, -kPalmHalf - 2}, {0, kPalmHalf + 2});
  draw_tube(drawing);
  draw_rings(drawing);
  fill_box(drawing, {-kPalmEnd, -kPalmHalf}, {-kFingerBase, kPalmHalf}, 118);
  fill_box(drawing, {-kFingerBase - 10, -kPalmHalf}, {-kFingerBase - 6, kPalmHalf}, 70);
  add_wear(drawing);
  return drawing;
}

Drawing draw_finger() {
  Drawing drawing = blank({-kPalmEnd, -2}, {kFingerTip + 2, kFingerWidth + 2});
  fill_box(drawing, {-kPalmEnd + 4, 0}, {kFingerTip, kFingerWidth}, 92);
  fill_box(drawing, {-10, 0}, {kFingerTip, 5}, 40);
  add_wear(drawing);
  return drawing;
}

Drawing mirrored(const Drawing& drawing) {
  Drawing result = drawing;
  cv::flip(drawing.colour, result.colour, 0);
  cv::flip(drawing.cover, result.cover, 0);
  result.origin.y = drawing.cover.rows - 1 - drawing.origin.y;
  return result;
}

}  // namespace mbncc::sim
