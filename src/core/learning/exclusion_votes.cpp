#include "learning/exclusion_votes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc {
namespace {

constexpr int kBox = 3;            // [px] looks are averaged over this square
constexpr int kMostSamples = 200;  // of a stroke or of the rest
constexpr float kTolerance = 2;    // [grey levels] added to distances: as near as noise allows
constexpr float kWeight = 4;       // log-odds per e-fold of distance, of colours and change each
constexpr float kLoudest = 10;     // log-odds of a vote

using Colours = std::vector<cv::Vec3f>;

// Colours of some pixels and their change against the picture after.
struct Samples {
  Colours colours, change;
};

struct Looks {
  cv::Mat colours, change;  // CV_32FC3

  explicit Looks(const CutPictures& cut) {
    cv::blur(cut.before, colours, {kBox, kBox});
    cv::blur(cut.before - cut.after, change, {kBox, kBox});
  }

  Samples draw(const cv::Mat& mask) const {
    const int step = std::max(1, cv::countNonZero(mask) / kMostSamples);
    Samples samples;
    int seen = 0;
    for (int y = 0; y < mask.rows; ++y)
      for (int x = 0; x < mask.cols; ++x)
        if (mask.at<uchar>(y, x) && seen++ % step == 0) {
          samples.colours.push_back(colours.at<cv::Vec3f>(y, x));
          samples.change.push_back(change.at<cv::Vec3f>(y, x));
        }
    return samples;
  }
};

// Logarithm of the distance to the nearest of some.
float log_distance(const cv::Vec3f& colour, const Colours& samples) {
  float least = std::numeric_limits<float>::max();
  for (const auto& sample : samples) {
    const cv::Vec3f apart = colour - sample;
    least = std::min(least, apart.dot(apart));
  }
  return std::log(std::sqrt(least) + kTolerance);
}

// How much nearer `colour` is to the one than to the other.
float preference(const cv::Vec3f& colour, const Colours& one, const Colours& other) {
  return log_distance(colour, other) - log_distance(colour, one);
}

// Pixels of `mask` whose unary is at least their median.
cv::Mat surer_half(const cv::Mat& mask, const cv::Mat& unary) {
  std::vector<float> values;
  for (int y = 0; y < mask.rows; ++y)
    for (int x = 0; x < mask.cols; ++x)
      if (mask.at<uchar>(y, x)) values.push_back(unary.at<float>(y, x));
  if (values.empty()) return mask;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return mask & (unary >= *middle);
}

}  // namespace

// Of the rest of the map only the surer half speaks for the object: the other may be wrong for the
// same reason as what was excluded.
cv::Mat exclusion_votes(const CutPictures& cut, const cv::Mat& excluded) {
  cv::Mat votes = cv::Mat::zeros(cut.map.size(), CV_32FC1);
  const Looks looks(cut);
  const cv::Mat rest = cut.map & ~excluded;
  const Samples stroke = looks.draw(excluded), object = looks.draw(surer_half(rest, cut.unary));
  if (stroke.colours.empty() || object.colours.empty()) return votes;
  for (int y = 0; y < rest.rows; ++y)
    for (int x = 0; x < rest.cols; ++x) {
      if (!rest.at<uchar>(y, x)) continue;
      const float by_colours =
          preference(looks.colours.at<cv::Vec3f>(y, x), stroke.colours, object.colours);
      const float by_change =
          preference(looks.change.at<cv::Vec3f>(y, x), stroke.change, object.change);
      votes.at<float>(y, x) = std::clamp(kWeight * (by_colours + by_change), -kLoudest, kLoudest);
    }
  return votes;
}

}  // namespace mbncc
