#include "learning/graph_cut.hpp"

#include <algorithm>
#include <opencv2/imgproc/detail/gcgraph.hpp>

namespace mbncc {

cv::Mat minimum_cut(const cv::Mat& unary, const Smoothness& smoothness) {
  const int width = unary.cols, pixels = static_cast<int>(unary.total());
  cv::detail::GCGraph<float> graph(pixels, 8 * pixels);
  for (int y = 0; y < unary.rows; ++y)
    for (int x = 0; x < width; ++x) {
      const int pixel = graph.addVtx();
      const float preference = unary.at<float>(y, x);
      graph.addTermWeights(pixel, std::max(0.F, preference), std::max(0.F, -preference));
      for (std::size_t k = 0; k < smoothness.weights.size(); ++k) {
        const float weight = smoothness.weights[k].at<float>(y, x);
        if (weight <= 0) continue;
        const int neighbour = pixel + Smoothness::kDy[k] * width + Smoothness::kDx[k];
        graph.addEdges(pixel, neighbour, weight, weight);
      }
    }
  graph.maxFlow();
  cv::Mat map(unary.size(), CV_8UC1);
  for (int i = 0; i < pixels; ++i)
    map.at<uchar>(i / width, i % width) = graph.inSourceSegment(i) ? 255 : 0;
  return map;
}

}  // namespace mbncc
