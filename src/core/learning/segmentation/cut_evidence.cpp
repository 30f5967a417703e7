// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/cut_evidence.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "learning/segmentation/clean_map.hpp"
#include "learning/segmentation/graph_cut.hpp"
#include "learning/segmentation/map_measures.hpp"

namespace mbncc::segmentation {
namespace {

constexpr float kBalanceShift = 2;  // log-odds per pixel by which the re-cuts are shifted
constexpr float kSurelyChanged = 0.7F;
constexpr int kAdjoining = 5;  // [px] square around a pixel beyond the region
// [px] Square around a map pixel; change inside it is the map's rim.
constexpr int kBeside = 7;

double part(const cv::Mat& of, const cv::Mat& among) {
  const int all = cv::countNonZero(among);
  return all == 0 ? 0 : cv::countNonZero(of & among) / static_cast<double>(all);
}

// Mean strength of the edges along the outline; 1: no smoothness cost. Parts drawn by the operator
// need no edge.
double boundary_contrast(const FinishedCut& cut, const Smoothness& smoothness) {
  const cv::Mat& map = cut.map;
  const auto is_confirmed = [&cut](int y, int x) {
    return !cut.confirmed.empty() && cut.confirmed.at<uchar>(y, x);
  };
  double cost = 0, length = 0;
  for (const int k : {0, 2})  // left and upper neighbour
    for (int y = 1; y < map.rows; ++y)
      for (int x = 1; x < map.cols; ++x)
        if (map.at<uchar>(y, x) != map.at<uchar>(y + Smoothness::kDy[k], x + Smoothness::kDx[k])) {
          if (!is_confirmed(y, x))
            cost += smoothness.weights[k].at<float>(y, x) / smoothness.strength;
          ++length;
        }
  return 1 - cost / std::max(1.0, length);
}

// Certain change outside the map that no stroke has explained: an arrival, or a missing part.
double change_beside(const FinishedCut& cut) {
  cv::Mat grown;
  cv::dilate(cut.map, grown, cv::Mat::ones(kBeside, kBeside, CV_8U));
  cv::Mat beside = (cut.changed > kSurelyChanged) & cut.inside & ~grown;
  if (!cut.confirmed.empty()) beside.setTo(0, cut.confirmed);
  return cv::countNonZero(beside) / std::max(1.0, static_cast<double>(cv::countNonZero(cut.map)));
}

// Part of the outline where the object may continue: pixels beyond the region look like it, or an
// intruder covers it.
double cut_off(const FinishedCut& cut) {
  cv::Mat beyond = cut.object_like & ~cut.inside;
  if (!cut.intruders.empty()) beyond |= cut.intruders;
  if (!cut.confirmed.empty()) beyond.setTo(0, cut.confirmed);
  cv::dilate(beyond, beyond, cv::Mat::ones(kAdjoining, kAdjoining, CV_8U));
  return part(beyond, outline_pixels(cut.map));
}

// IoU of the map with another cut, in which pixels under strokes agree.
double agreement(const FinishedCut& cut, const cv::Mat& other) {
  cv::Mat same = cut.map & other, either = cut.map | other;
  if (!cut.confirmed.empty()) same |= either & cut.confirmed;
  const int all = cv::countNonZero(either);
  return all == 0 ? 0 : cv::countNonZero(same) / static_cast<double>(all);
}

// Least IoU of the map with two cuts at half resolution whose unary is shifted in either direction.
double stability(const FinishedCut& cut, const Smoothness& half) {
  double least = 1;
  for (const float tilt : {-kBalanceShift, kBalanceShift}) {
    cv::Mat tilted = tilted_coarse_cut(cut.coarse, cut.unary, tilt, half);
    keep_main_groups(tilted, cut.unary + tilt, cut.kept);
    least = std::min(least, agreement(cut, tilted));
  }
  return least;
}

}  // namespace

double region_touch(const cv::Mat& map, const cv::Mat& inside) {
  cv::Mat core;
  cv::erode(inside, core, cv::Mat(), {-1, -1}, 2, cv::BORDER_CONSTANT, cv::Scalar(0));
  return part(~core, outline_pixels(map));
}

double region_span(const cv::Mat& map, const cv::Mat& inside) {
  const cv::Rect box = cv::boundingRect(map), region = cv::boundingRect(inside);
  if (region.empty()) return 1;
  return std::min({1.0, box.width / double(region.width), box.height / double(region.height)});
}

CutEvidence cut_evidence(const FinishedCut& cut, const Smoothness& smoothness,
                         const Smoothness& half) {
  CutEvidence evidence;
  evidence.region_touch = region_touch(cut.map, cut.inside);
  evidence.cut_off = cut_off(cut);
  evidence.region_span = region_span(cut.map, cut.inside);
  evidence.change_outside = part(cut.changed > kSurelyChanged, ~cut.inside);
  evidence.change_beside = change_beside(cut);
  evidence.stability = stability(cut, half);
  evidence.boundary_contrast = boundary_contrast(cut, smoothness);
  return evidence;
}

}  // namespace mbncc::segmentation
