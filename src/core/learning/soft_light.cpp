#include "learning/soft_light.hpp"

#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc {
namespace {

constexpr double kBlur = 1.2;           // [px]
constexpr float kDark = 4;              // [grey levels] added to both pictures
constexpr float kSteepest = 0.022F;     // slope of the logarithm of light in a penumbra [1 / px]
constexpr float kNoiseSlope = 0.12F;    // likewise by noise, per part of the brightness
constexpr float kBrightest = 0.1F;      // logarithm of light on the way
constexpr float kShadowLight = -0.04F;  // and where there surely is one
constexpr float kSurelyChanged = 0.8F;  // such pixels end the way
constexpr int kPassage =
    9;  // [px] narrower ways are gaps in an outline, narrower shadows thin parts
constexpr float kHardlyChanged = 0.03F;   // probability of change on the ground to start from
constexpr float kUnchangedLight = 0.05F;  // logarithm of light on it
constexpr double kGroundPart = 0.2;       // least part of it in what is reached

cv::Mat smooth_grey(const cv::Mat& picture) {
  cv::Mat grey;
  cv::transform(picture, grey, cv::Matx13f(1 / 3.F, 1 / 3.F, 1 / 3.F));
  cv::GaussianBlur(grey, grey, {}, kBlur);
  return grey + kDark;
}

cv::Mat slope_of(const cv::Mat& values) {
  cv::Mat across, down, slope;
  cv::Sobel(values, across, CV_32F, 1, 0, 3, 1.0 / 8);
  cv::Sobel(values, down, CV_32F, 0, 1, 3, 1.0 / 8);
  cv::magnitude(across, down, slope);
  return slope;
}

void open_passages(cv::Mat& mask) {
  cv::morphologyEx(mask, mask, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kPassage, kPassage}));
}

// Patches of `open` of which `ground` is a good part.
cv::Mat reached_from(const cv::Mat& ground, const cv::Mat& open) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(open, labels, stats, centres, 4, CV_32S);
  std::vector<int> grounded(count, 0);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x)
      if (ground.at<uchar>(y, x)) ++grounded[labels.at<int>(y, x)];
  cv::Mat reached = cv::Mat::zeros(open.size(), CV_8UC1);
  for (int y = 0; y < labels.rows; ++y)
    for (int x = 0; x < labels.cols; ++x) {
      const int label = labels.at<int>(y, x);
      if (label != 0 && grounded[label] > kGroundPart * stats.at<int>(label, cv::CC_STAT_AREA))
        reached.at<uchar>(y, x) = 255;
    }
  return reached;
}

}  // namespace

cv::Mat soft_shadow(const cv::Mat& before, const cv::Mat& after, const cv::Mat& changed,
                    float sigma) {
  const cv::Mat platform = smooth_grey(after);
  cv::Mat light;
  cv::log(smooth_grey(before) / platform, light);
  const cv::Mat steepest = cv::max(kNoiseSlope * sigma / platform, kSteepest);
  cv::Mat open = (slope_of(light) < steepest) & (light < kBrightest) & (changed < kSurelyChanged);
  open_passages(open);
  const cv::Mat ground = (changed < kHardlyChanged) & (cv::abs(light) < kUnchangedLight);
  cv::Mat shadow = reached_from(ground, open) & (light < kShadowLight);
  open_passages(shadow);
  return shadow;
}

}  // namespace mbncc
