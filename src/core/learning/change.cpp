#include "mbncc/learning/change.hpp"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace mbncc {
namespace {

constexpr int kSurveyWidth = 320;       // [px]
constexpr float kLeastDifference = 18;  // [grey levels, summed over channels] above any usual noise
constexpr float kNoiseFactor = 5;       // a change stands out from the median difference this much
constexpr float kSureDifference = 45;   // [likewise] a change, however much else differs

cv::Mat reduced(const cv::Mat& picture, double scale) {
  cv::Mat small;
  cv::resize(picture, small, {}, scale, scale, cv::INTER_AREA);
  cv::Mat values;
  small.convertTo(values, CV_32F);
  return values;
}

float median(std::vector<float>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Median ratio of the two pictures per channel; dark and saturated pixels say nothing.
cv::Vec3f exposure_ratio(const cv::Mat& before, const cv::Mat& after) {
  std::array<std::vector<float>, 3> ratios;
  for (int y = 0; y < before.rows; y += 2)
    for (int x = 0; x < before.cols; x += 2)
      for (int c = 0; c < 3; ++c) {
        const float b = before.at<cv::Vec3f>(y, x)[c], a = after.at<cv::Vec3f>(y, x)[c];
        if (a > 10 && a < 245 && b < 245) ratios[c].push_back(b / a);
      }
  cv::Vec3f gain(1, 1, 1);
  for (int c = 0; c < 3; ++c)
    if (ratios[c].size() > 100) gain[c] = median(ratios[c]);
  return gain;
}

// Difference of the pictures, summed over channels, averaged over 3 x 3.
cv::Mat difference_of(const cv::Mat& before, const cv::Mat& after, const cv::Vec3f& gain) {
  cv::Mat difference(before.size(), CV_32FC1);
  for (int y = 0; y < before.rows; ++y)
    for (int x = 0; x < before.cols; ++x) {
      const cv::Vec3f d = before.at<cv::Vec3f>(y, x) - after.at<cv::Vec3f>(y, x).mul(gain);
      difference.at<float>(y, x) = std::abs(d[0]) + std::abs(d[1]) + std::abs(d[2]);
    }
  cv::blur(difference, difference, {3, 3});
  return difference;
}

float change_threshold(const cv::Mat& difference) {
  std::vector<float> values(difference.begin<float>(), difference.end<float>());
  return std::clamp(kNoiseFactor * median(values), kLeastDifference, kSureDifference);
}

}  // namespace

ChangeSurvey survey_change(const cv::Mat& before, const cv::Mat& after) {
  const double scale = std::min(1.0, static_cast<double>(kSurveyWidth) / before.cols);
  const cv::Mat b = reduced(before, scale), a = reduced(after, scale);
  const cv::Vec3f gain = exposure_ratio(b, a);
  const cv::Mat difference = difference_of(b, a, gain);
  cv::Mat changed = difference > change_threshold(difference);
  cv::morphologyEx(changed, changed, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {3, 3}));
  ChangeSurvey survey;
  survey.fraction = cv::countNonZero(changed) / static_cast<double>(changed.total());
  survey.gain = (gain[0] + gain[1] + gain[2]) / 3;
  cv::resize(changed, survey.changed, before.size(), 0, 0, cv::INTER_NEAREST);
  return survey;
}

cv::Rect changed_region(const ChangeSurvey& survey) {
  constexpr int kGap = 9;  // [px] pieces nearer than this belong together
  cv::Mat joined, labels, stats, centres;
  cv::morphologyEx(survey.changed, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  const int count = cv::connectedComponentsWithStats(joined, labels, stats, centres, 8, CV_32S);
  int largest = 0;
  for (int i = 1; i < count; ++i)
    if (largest == 0 ||
        stats.at<int>(i, cv::CC_STAT_AREA) > stats.at<int>(largest, cv::CC_STAT_AREA))
      largest = i;
  if (largest == 0) return {};
  const cv::Rect box(
      stats.at<int>(largest, cv::CC_STAT_LEFT), stats.at<int>(largest, cv::CC_STAT_TOP),
      stats.at<int>(largest, cv::CC_STAT_WIDTH), stats.at<int>(largest, cv::CC_STAT_HEIGHT));
  const int margin = std::max(8, std::max(box.width, box.height) * 15 / 100);
  const cv::Rect grown(box.x - margin, box.y - margin, box.width + 2 * margin,
                       box.height + 2 * margin);
  return grown & cv::Rect({0, 0}, survey.changed.size());
}

}  // namespace mbncc
