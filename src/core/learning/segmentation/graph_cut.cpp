// SPDX-License-Identifier: BSD-3-Clause
#include "learning/segmentation/graph_cut.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <opencv2/imgproc/detail/gcgraph.hpp>
#include <vector>

#include "learning/segmentation/half_smoothness.hpp"

namespace mbncc::segmentation {
namespace {

constexpr int kBand = 4;         // [px] on either side of a coarse outline
constexpr int kAround = 7;       // [px] square around a pixel that disagrees with a coarse cut
constexpr float kDisagrees = 2;  // unary term from which a pixel disagrees

// Cuts only the open pixels of a map; the others keep their labels.
class PartialCut {
 public:
  PartialCut(const cv::Mat& unary, const Smoothness& smoothness, const cv::Mat& open, cv::Mat& map)
      : unary_(unary), smoothness_(smoothness), map_(map), vertices_(map.size(), CV_32SC1) {
    pixels_ = number_vertices(open);
  }

  void run() {
    if (pixels_.empty()) return;
    const auto count = static_cast<unsigned>(pixels_.size());
    cv::detail::GCGraph<float> graph(count, 8 * count);
    for (std::size_t i = 0; i < pixels_.size(); ++i) graph.addVtx();
    std::vector<float> preferences(pixels_.size());
    for (std::size_t i = 0; i < pixels_.size(); ++i)
      preferences[i] = unary_.at<float>(pixels_[i]) + add_edges(graph, pixels_[i]);
    for (std::size_t i = 0; i < pixels_.size(); ++i)
      graph.addTermWeights(static_cast<int>(i), std::max(0.F, preferences[i]),
                           std::max(0.F, -preferences[i]));
    if (has_edges_) graph.maxFlow();
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      const bool object =
          has_edges_ ? graph.inSourceSegment(static_cast<int>(i)) : preferences[i] > 0;
      map_.at<uchar>(pixels_[i]) = object ? 255 : 0;
    }
  }

 private:
  static constexpr int kClosed = -1;

  std::vector<cv::Point> number_vertices(const cv::Mat& open) {
    std::vector<cv::Point> pixels;
    vertices_ = kClosed;
    for (int y = 0; y < open.rows; ++y)
      for (int x = 0; x < open.cols; ++x)
        if (open.at<uchar>(y, x)) {
          vertices_.at<int>(y, x) = static_cast<int>(pixels.size());
          pixels.emplace_back(x, y);
        }
    return pixels;
  }

  // Returns the contribution of the closed neighbours to the unary.
  float add_edges(cv::detail::GCGraph<float>& graph, const cv::Point& pixel) {
    float push = 0;
    const int own = vertices_.at<int>(pixel);
    for (std::size_t k = 0; k < smoothness_.weights.size(); ++k) {
      const cv::Point step(Smoothness::kDx[k], Smoothness::kDy[k]);
      if (const float w = smoothness_.weights[k].at<float>(pixel); w > 0) {
        const int neighbour = vertices_.at<int>(pixel + step);
        if (neighbour == kClosed)
          push += side(pixel + step) * w;
        else
          graph.addEdges(own, neighbour, w, w);
        has_edges_ = has_edges_ || neighbour != kClosed;
      }
      const cv::Point later = pixel - step;
      if (!cv::Rect({0, 0}, map_.size()).contains(later)) continue;
      const float w = smoothness_.weights[k].at<float>(later);
      if (w > 0 && vertices_.at<int>(later) == kClosed) push += side(later) * w;
    }
    return push;
  }

  float side(const cv::Point& pixel) const { return map_.at<uchar>(pixel) ? 1.F : -1.F; }

  const cv::Mat& unary_;
  const Smoothness& smoothness_;
  cv::Mat& map_;
  cv::Mat vertices_;  // CV_32SC1
  std::vector<cv::Point> pixels_;
  bool has_edges_ = false;
};

// Pixels where a cut at half resolution may be wrong: near its outline, and where details disagree.
cv::Mat uncertain_band(const cv::Mat& map, const cv::Mat& unary) {
  const cv::Mat object = map > 0;
  cv::Mat grown, shrunk,
      disagrees = (object & (unary < -kDisagrees)) | (~object & (unary > kDisagrees));
  const cv::Mat band = cv::Mat::ones(2 * kBand + 1, 2 * kBand + 1, CV_8U);
  cv::dilate(map, grown, band);
  cv::erode(map, shrunk, band);
  cv::dilate(disagrees, disagrees, cv::Mat::ones(kAround, kAround, CV_8U));
  return (grown & ~shrunk) | disagrees;
}

cv::Mat full_resolution(const cv::Mat& coarse, const cv::Size& size) {
  cv::Mat map;
  cv::resize(coarse, map, coarse.size() * 2, 0, 0, cv::INTER_NEAREST);
  return map(cv::Rect({0, 0}, size)).clone();
}

}  // namespace

cv::Mat minimum_cut(const cv::Mat& unary, const Smoothness& smoothness) {
  cv::Mat map = cv::Mat::zeros(unary.size(), CV_8UC1);
  const cv::Mat everywhere(unary.size(), CV_8UC1, cv::Scalar(255));
  PartialCut(unary, smoothness, everywhere, map).run();
  return map;
}

cv::Mat coarse_cut(const cv::Mat& unary, const Smoothness& half) {
  return full_resolution(minimum_cut(half_resolution(unary), half), unary.size());
}

cv::Mat tilted_coarse_cut(const cv::Mat& coarse, const cv::Mat& unary, float tilt,
                          const Smoothness& half) {
  cv::Mat map(half.weights[0].size(), CV_8UC1);
  for (int y = 0; y < map.rows; ++y)
    for (int x = 0; x < map.cols; ++x) map.at<uchar>(y, x) = coarse.at<uchar>(2 * y, 2 * x);
  PartialCut(half_resolution(unary + tilt), half, tilt > 0 ? map == 0 : map > 0, map).run();
  return full_resolution(map, unary.size());
}

void refine_cut(const cv::Mat& unary, const Smoothness& smoothness, cv::Mat& map) {
  PartialCut(unary, smoothness, uncertain_band(map, unary), map).run();
}

}  // namespace mbncc::segmentation
