#include "matching/response_maps.hpp"

#include <algorithm>
#include <array>

#include "polar/kernels.hpp"

namespace mbncc {
namespace {

constexpr int kOrientations = ResponseMaps::kOrientations;
constexpr std::int8_t kUnseen = 7;  // taken beyond the border, so that objects may hang over it

/// Responses before they are spread, continued by a pixel and more beyond the border.
class Responses {
 public:
  explicit Responses(const cv::Mat& edges) {
    for (auto& map : maps_) map.create(edges.rows, edges.cols + 4, CV_8SC1);
    for (int y = 0; y < edges.rows; ++y) {
      std::int8_t* rows[kOrientations / 2];
      for (int k = 0; k < kOrientations / 2; ++k) rows[k] = maps_[k].ptr<std::int8_t>(y) + 1;
      kernels::edge_responses(edges.ptr<std::int8_t>(y), rows, edges.cols);
      for (auto* row : rows) {
        row[-1] = row[0];
        for (int x = 0; x < 3; ++x) row[edges.cols + x] = row[edges.cols - 1];
      }
    }
    // Turned by a quarter, an edge responds the other way round.
    for (int k = 0; k < kOrientations / 2; ++k)
      cv::subtract(cv::Scalar(0), maps_[k], maps_[k + kOrientations / 2]);
  }

  std::array<const std::int8_t*, 3> around(int orientation, int y) const {
    const cv::Mat& map = maps_[orientation];
    return {map.ptr<std::int8_t>(std::max(0, y - 1)) + 1, map.ptr<std::int8_t>(y) + 1,
            map.ptr<std::int8_t>(std::min(map.rows - 1, y + 1)) + 1};
  }

 private:
  std::array<cv::Mat, kOrientations> maps_;  // CV_8SC1
};

}  // namespace

ResponseMaps::ResponseMaps(const cv::Mat& edges, int margin)
    : margin_(margin),
      stride_((edges.cols + 1) / kStep + margin + 1),
      plane_(stride_ * ((edges.rows + 1) / kStep + margin + kernels::kResponseRows)),
      values_(static_cast<std::size_t>(plane_) * kPhases * kOrientations + kernels::kPositions,
              kUnseen) {
  const Responses responses(edges);
  for (int k = 0; k < kOrientations; ++k)
    for (int y = 0; y < edges.rows; ++y) {
      std::int8_t* even = &values_[offset(k, 0, y)];
      std::int8_t* odd = &values_[offset(k, 1, y)];
      kernels::spread_rows(responses.around(k, y).data(), even, odd, edges.cols / kStep);
      if (edges.cols % kStep != 0) even[edges.cols / kStep] = even[edges.cols / kStep - 1];
    }
}

}  // namespace mbncc
