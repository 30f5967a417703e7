// SPDX-License-Identifier: BSD-3-Clause
#include "matching/evidence/differing_groups.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "imaging/rectangles.hpp"

namespace mbncc::evidence {

std::vector<Group> connected_groups(const cv::Mat& pixels) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(pixels, labels, stats, centres);
  std::vector<Group> groups;
  for (int i = 1; i < count; ++i) {
    const cv::Rect box = imaging::box_of_component(stats, i);
    groups.push_back({box,
                      {centres.at<double>(i, 0), centres.at<double>(i, 1)},
                      stats.at<int>(i, cv::CC_STAT_AREA),
                      labels(box) == i});
  }
  return groups;
}

LargestGroups largest_groups(const cv::Mat& differing, const cv::Mat& compared, int rim,
                             const std::function<bool(const cv::Point2d&)>& counts) {
  cv::Mat beside;
  cv::dilate(~compared, beside, cv::Mat::ones(2 * rim + 1, 2 * rim + 1, CV_8U));
  LargestGroups groups;
  for (const Group& group : connected_groups(differing & compared)) {
    if (group.size <= groups.enclosed || !counts(group.centre)) continue;
    groups.largest = std::max(groups.largest, group.size);
    if (cv::countNonZero(group.mask & beside(group.box)) == 0) groups.enclosed = group.size;
  }
  return groups;
}

}  // namespace mbncc::evidence
