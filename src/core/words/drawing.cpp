#include "mbncc/drawing.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace mbncc {
namespace {

constexpr double kAxisLength = 30;  // [px]
constexpr int kShift = 4;           // OpenCV's sub-pixel bits
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kXColour(60, 60, 230), kYColour(60, 200, 60), kShade(0, 0, 0);

// OpenCV draws with fixed-point coordinates; far-off points are kept from overflowing them.
cv::Point fixed_point(cv::Point2d point) {
  const auto bounded = [](double v) { return std::clamp(v, -30000.0, 30000.0) * (1 << kShift); };
  return {cvRound(bounded(point.x)), cvRound(bounded(point.y))};
}

void draw_outline(cv::Mat& picture, const std::vector<cv::Point2f>& outline,
                  const cv::Scalar& colour) {
  std::vector<cv::Point> corners;
  for (const auto& corner : outline) corners.push_back(fixed_point(corner));
  if (!corners.empty()) cv::polylines(picture, corners, true, colour, 1, cv::LINE_AA, kShift);
}

void draw_axis(cv::Mat& picture, const Pose2D& pose, cv::Point2d tip, const cv::Scalar& colour) {
  cv::line(picture, fixed_point(pose.position()), fixed_point(transform(pose, tip)), colour, 2,
           cv::LINE_AA, kShift);
}

void draw_caption(cv::Mat& picture, const Marking& marking) {
  const double scale = std::max(0.4, picture.cols / 1600.0);
  int baseline = 0;
  const cv::Size size = cv::getTextSize(marking.caption, kFont, scale, 1, &baseline);
  const auto within = [](double v, int low, int high) {
    return static_cast<int>(std::clamp(v, double(low), double(std::max(low, high))));
  };
  const cv::Point corner(within(marking.pose.x + 8, 0, picture.cols - size.width),
                         within(marking.pose.y - 8, size.height, picture.rows - baseline));
  cv::putText(picture, marking.caption, corner, kFont, scale, kShade, 3, cv::LINE_AA);
  cv::putText(picture, marking.caption, corner, kFont, scale, marking.colour, 1, cv::LINE_AA);
}

cv::Scalar colour_of(Verdict verdict) {
  if (verdict == Verdict::kGood) return {80, 220, 80};
  return verdict == Verdict::kMarginal ? cv::Scalar(60, 190, 250) : cv::Scalar(60, 60, 240);
}

}  // namespace

cv::Mat draw_markings(const cv::Mat& picture, const std::vector<Marking>& markings) {
  if (picture.empty() || (picture.type() != CV_8UC1 && picture.type() != CV_8UC3))
    throw std::invalid_argument("markings are drawn on 8-bit grey or colour pictures");
  cv::Mat drawn = picture.clone();
  if (picture.type() == CV_8UC1) cv::cvtColor(picture, drawn, cv::COLOR_GRAY2BGR);
  for (const auto& marking : markings) {
    for (const auto& outline : marking.outlines) draw_outline(drawn, outline, marking.colour);
    draw_axis(drawn, marking.pose, {kAxisLength, 0}, kXColour);
    draw_axis(drawn, marking.pose, {0, kAxisLength}, kYColour);
    draw_caption(drawn, marking);
  }
  return drawn;
}

Marking marking_of(const View& view, const Quality& quality, const std::string& caption) {
  Marking marking;
  for (const auto& outline : outlines(view)) {
    auto& placed = marking.outlines.emplace_back();
    for (const auto& point : outline) placed.emplace_back(transform(view.reference, point));
  }
  marking.pose = view.reference;
  marking.colour = colour_of(quality.verdict);
  marking.caption = caption;
  return marking;
}

}  // namespace mbncc
