#include "learning/stroke_voice.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <tuple>
#include <vector>

namespace mbncc {
namespace {

constexpr float kLoudest = 40;      // log-odds on the stroke
constexpr float kReach = 15;        // [px] of path over which they fall to 1 / e
constexpr float kColourStep = 0.5;  // [grey levels] that count as one pixel of path

// Dijkstra's algorithm from all painted pixels at once, as far as anything can be heard.
class PathLengths {
 public:
  PathLengths(const cv::Mat& picture, const cv::Mat& painted)
      : picture_(picture),
        lengths_(picture.size(), CV_32FC1, cv::Scalar(std::numeric_limits<float>::infinity())) {
    for (int y = 0; y < painted.rows; ++y)
      for (int x = 0; x < painted.cols; ++x)
        if (painted.at<uchar>(y, x)) reach({x, y}, 0);
    while (!front_.empty()) {
      const auto [length, y, x] = front_.top();
      front_.pop();
      if (length <= lengths_.at<float>(y, x)) go_on_from({x, y}, length);
    }
  }

  const cv::Mat& lengths() const { return lengths_; }

 private:
  using Arrival = std::tuple<float, int, int>;  // length, y, x

  void reach(const cv::Point& pixel, float length) {
    if (length > 4 * kReach || length >= lengths_.at<float>(pixel)) return;
    lengths_.at<float>(pixel) = length;
    front_.emplace(length, pixel.y, pixel.x);
  }

  void go_on_from(const cv::Point& pixel, float length) {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const cv::Point next = pixel + cv::Point(dx, dy);
        if ((dx == 0 && dy == 0) || !cv::Rect({0, 0}, picture_.size()).contains(next)) continue;
        const cv::Vec3f step = picture_.at<cv::Vec3f>(next) - picture_.at<cv::Vec3f>(pixel);
        reach(next, length + std::hypot(static_cast<float>(dx), static_cast<float>(dy)) +
                        std::sqrt(step.dot(step)) / kColourStep);
      }
  }

  const cv::Mat& picture_;
  cv::Mat lengths_;
  std::priority_queue<Arrival, std::vector<Arrival>, std::greater<>> front_;
};

}  // namespace

cv::Mat stroke_voice(const cv::Mat& picture, const cv::Mat& painted) {
  cv::Mat smooth, voice;  // noise would make every path long
  cv::blur(picture, smooth, {3, 3});
  cv::exp(PathLengths(smooth, painted).lengths() * (-1 / kReach), voice);
  return kLoudest * voice;
}

}  // namespace mbncc
