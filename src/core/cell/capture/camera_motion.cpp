// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/camera_motion.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace mbncc {
namespace {

constexpr int kWidth = 320;          // [px] width at which the images are compared
constexpr int kTile = 64;            // [px]
constexpr double kTexture = 2.5;     // [grey levels] least deviation of a trackable tile
constexpr double kFollowed = 0.25;   // least phase correlation response of a tracked tile
constexpr double kMoved = 0.5;       // [px] at kWidth; tiles displaced less are still
constexpr int kFewest = 3;           // displaced tiles that show a moved camera
constexpr double kNearlyAll = 0.75;  // part of the tracked tiles that must be displaced

cv::Mat comparable(const cv::Mat& image) {
  cv::Mat grey, small;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  const double scale = std::min(1.0, double{kWidth} / image.cols);
  cv::resize(grey, small, {}, scale, scale, cv::INTER_AREA);
  small.convertTo(small, CV_32F);
  return small;
}

bool has_texture(const cv::Mat& tile) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(tile, mean, deviation);
  return deviation[0] > kTexture;
}

/// The images are cloned because cv::phaseCorrelate() multiplies them by the window in place.
cv::Point2d displacement(const cv::Mat& from, const cv::Mat& to, const cv::Mat& window,
                         double* response = nullptr) {
  return cv::phaseCorrelate(from.clone(), to.clone(), window, response);
}

cv::Rect overlap(const cv::Size& size, const cv::Point& shift) {
  return cv::Rect({}, size) & cv::Rect(shift, size);
}

}  // namespace

bool camera_moved(const cv::Mat& before, const cv::Mat& after) {
  const cv::Mat was = comparable(before), is = comparable(after);
  cv::Mat window;
  cv::createHanningWindow(window, was.size(), CV_32F);
  const cv::Point2d whole = displacement(was, is, window);
  cv::createHanningWindow(window, {kTile, kTile}, CV_32F);
  // Each tile is tracked from two positions: displaced like the whole image, and not displaced.
  int moved = 0, stood = 0;
  const cv::Point coarse(cvRound(whole.x), cvRound(whole.y));
  const cv::Rect seen = overlap(is.size(), coarse);
  for (int y = seen.y; y + kTile <= seen.br().y; y += kTile)
    for (int x = seen.x; x + kTile <= seen.br().x; x += kTile) {
      const cv::Rect there(x, y, kTile, kTile);
      if (!has_texture(is(there))) continue;
      double there_response = 0, here_response = 0;
      const cv::Point2d rest =
          displacement(was(there - coarse), is(there), window, &there_response);
      const cv::Point2d stays = displacement(was(there), is(there), window, &here_response);
      const bool went = there_response >= here_response;
      if (std::max(there_response, here_response) < kFollowed) continue;
      const cv::Point2d shift = went ? cv::Point2d(coarse) + rest : stays;
      ++(std::hypot(shift.x, shift.y) > kMoved ? moved : stood);
    }
  return moved >= kFewest && moved >= kNearlyAll * (moved + stood);
}

}  // namespace mbncc
