#include "cell/known_instances.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace mbncc {
namespace {

cv::Mat filled(const std::vector<cv::Point2f>& outline, const cv::Rect& box) {
  std::vector<cv::Point> corners;
  for (const auto& point : outline)
    corners.emplace_back(cvRound(point.x) - box.x, cvRound(point.y) - box.y);
  cv::Mat area = cv::Mat::zeros(box.size(), CV_8UC1);
  cv::fillPoly(area, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return area;
}

}  // namespace

cv::Rect Known::box() const {
  return cv::boundingRect(match.outline);
}

double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b) {
  const cv::Rect box_a = cv::boundingRect(a), box_b = cv::boundingRect(b);
  if ((box_a & box_b).empty()) return 0;
  const cv::Rect both = box_a | box_b;
  const cv::Mat area_a = filled(a, both), area_b = filled(b, both);
  const int smaller = std::min(cv::countNonZero(area_a), cv::countNonZero(area_b));
  return smaller > 0 ? static_cast<double>(cv::countNonZero(area_a & area_b)) / smaller : 0;
}

bool is_continued(const Match& before, const Match& now, double reach) {
  return before.name == now.name && cv::norm(before.pose.position() - now.pose.position()) <= reach;
}

const Known* predecessor(const std::vector<Known>& before, const Match& now, double reach) {
  const Known* nearest = nullptr;
  for (const auto& known : before) {
    const double distance = cv::norm(known.match.pose.position() - now.pose.position());
    if (!is_continued(known.match, now, reach)) continue;
    if (nearest && cv::norm(nearest->match.pose.position() - now.pose.position()) <= distance)
      continue;
    nearest = &known;
  }
  return nearest;
}

}  // namespace mbncc
