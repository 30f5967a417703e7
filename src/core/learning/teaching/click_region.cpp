// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/click_region.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <set>

#include "imaging/rectangles.hpp"
#include "learning/segmentation/cut_evidence.hpp"
#include "learning/teaching/lesson_progress.hpp"
#include "mbncc/learning/region_cut.hpp"

namespace mbncc::teaching {
namespace {

constexpr double kSquareStep = 0.8;   // ratio of the sides of consecutive squares
constexpr int kSmallestSquare = 20;   // [px]
constexpr double kLargestPart = 0.6;  // side of the largest square per shorter side of the image
constexpr double kSameArea = 1.25;    // factor up to which the maps of two squares agree
constexpr double kAgreement = 0.1;    // weight of one more agreeing square, relative to clarity
constexpr double kEnoughSquares = 6;  // squares that agree on most correct and few wrong maps
constexpr int kGap = 9;               // [px] pieces nearer than this are joined
constexpr double kMissed = 15;        // [px] largest distance of a click to its piece

struct Candidate {
  cv::Rect region;
  cv::Mat piece;  // of the region's size
  int area;       // [px]
  double clarity;
};

// Number of squares whose map is about as large as that of `one`, which is included.
int agreeing(const Candidate& one, const std::vector<Candidate>& candidates) {
  return static_cast<int>(
      std::count_if(candidates.begin(), candidates.end(), [&](const Candidate& other) {
        return std::max(one.area, other.area) < kSameArea * std::min(one.area, other.area);
      }));
}

// Label of the piece nearest to the click; 0 if none is near enough.
int label_near(const cv::Mat& labels, const cv::Point2d& click) {
  double nearest = kMissed;
  int chosen = 0;
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const double distance = std::hypot(x - click.x, y - click.y);
      if (labels.at<int>(y, x) == 0 || distance >= nearest) continue;
      nearest = distance;
      chosen = labels.at<int>(y, x);
    }
  return chosen;
}

cv::Mat labels_of(const cv::Mat& mask) {
  cv::Mat labels;
  cv::connectedComponents(mask, labels, 8, CV_32S);
  return labels;
}

cv::Mat piece(const cv::Mat& labels, int label) {
  return label == 0 ? cv::Mat::zeros(labels.size(), CV_8UC1) : cv::Mat(labels == label);
}

// Label of the piece that encloses `hole`; 0 if that is empty.
int label_around(const cv::Mat& hole, const cv::Mat& labels) {
  const cv::Rect box = cv::boundingRect(hole);
  for (int x = box.x; x < box.br().x; ++x)
    if (hole.at<uchar>(box.y, x)) return labels.at<int>(box.y - 1, x);
  return 0;
}

}  // namespace

std::vector<cv::Rect> squares_about(const cv::Point2d& click, double largest,
                                    const cv::Rect& room) {
  std::vector<cv::Rect> squares;
  for (double side = largest; side >= kSmallestSquare; side *= kSquareStep) {
    const cv::Rect square(cvRound(click.x - side / 2), cvRound(click.y - side / 2), cvRound(side),
                          cvRound(side));
    const cv::Rect inside = square & room;
    if (std::min(inside.width, inside.height) >= kSmallestSquare / 2) squares.push_back(inside);
  }
  return squares;
}

std::optional<ClickedRegion> stable_region(const cv::Mat& image, const cv::Point2d& click,
                                           int iterations) {
  std::vector<Candidate> candidates;
  const double largest = kLargestPart * std::min(image.cols, image.rows);
  for (const cv::Rect& region : squares_about(click, largest, {{0, 0}, image.size()})) {
    const ObjectCut cut = region_cut(image, region, iterations);
    // One image cannot tell an object from what encloses it.
    const cv::Mat labels = labels_of(cut.map), map = piece(labels, label_near(labels, click));
    const int area = cv::countNonZero(map);
    if (area > 0)
      candidates.push_back(
          {region, map(region).clone(), area, segmentation::edge_clarity(cut.evidence)});
  }
  const auto worth = [&](const Candidate& one) {
    return one.clarity + kAgreement * agreeing(one, candidates);
  };
  const auto best =
      std::max_element(candidates.begin(), candidates.end(),
                       [&](const Candidate& a, const Candidate& b) { return worth(a) < worth(b); });
  if (best == candidates.end()) return std::nullopt;
  ClickedRegion found{best->region, cv::Mat::zeros(image.size(), CV_8UC1),
                      std::min(1., agreeing(*best, candidates) / kEnoughSquares)};
  best->piece.copyTo(found.map(best->region));
  return found;
}

cv::Mat piece_at(const cv::Mat& mask, const cv::Point2d& click) {
  const cv::Mat labels = labels_of(mask);
  const int near = label_near(labels, click);
  return piece(labels, near != 0 ? near : label_around(hole_at(mask, click), labels));
}

cv::Mat pieces_with(const cv::Mat& mask, const cv::Mat& seed) {
  const cv::Mat labels = labels_of(mask);
  std::vector<cv::Point> pixels;
  cv::findNonZero(mask & seed, pixels);
  std::set<int> wanted;
  for (const auto& pixel : pixels) wanted.insert(labels.at<int>(pixel));
  cv::Mat pieces = cv::Mat::zeros(mask.size(), CV_8UC1);
  for (const int label : wanted) pieces |= piece(labels, label);
  return pieces;
}

cv::Mat hole_at(const cv::Mat& mask, const cv::Point2d& click) {
  cv::Mat beside = cv::Mat::zeros(mask.size(), CV_8UC1);
  const cv::Point at(cvFloor(click.x), cvFloor(click.y));
  cv::circle(beside, at, static_cast<int>(kMissed), cv::Scalar(255), cv::FILLED);
  if (cv::countNonZero(beside & mask) > 0) return cv::Mat::zeros(mask.size(), CV_8UC1);
  cv::Mat labels, stats, centres;
  cv::connectedComponentsWithStats(~mask, labels, stats, centres, 4, CV_32S);
  const int hole = labels.at<int>(at);
  const cv::Rect box = imaging::box_of_component(stats, hole);
  if (imaging::grown(box, 1) != (imaging::grown(box, 1) & cv::Rect({0, 0}, mask.size())))
    return cv::Mat::zeros(mask.size(), CV_8UC1);
  return labels == hole;
}

cv::Mat change_at_click(const cv::Mat& changed, const cv::Point2d& click) {
  cv::Mat joined;
  cv::morphologyEx(changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  return changed & piece_at(joined, click);
}

void refuse_click() {
  throw LessonEnded(LearnError::kSegmentationEmpty, "No object stands out at the click.",
                    "Click on the object itself, or draw a region (roi) around it.");
}

}  // namespace mbncc::teaching
