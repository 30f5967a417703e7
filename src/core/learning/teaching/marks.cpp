// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/marks.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "learning/teaching/lesson_checks.hpp"
#include "learning/teaching/lesson_progress.hpp"

namespace mbncc::teaching {
namespace {

constexpr double kWidestStroke = 1000;  // [px]
constexpr int kFractionBits = 4;
constexpr const char* kOutside =
    "A stroke does not lie in the image: points are pixels of the learning image.";

std::vector<cv::Point> fixed_point(const LessonEdit::Line& line) {
  std::vector<cv::Point> points;
  for (const auto& point : line) {
    if (!is_near_image(point)) throw LessonEnded(LearnError::kRegionInvalid, kOutside);
    points.emplace_back(cvRound(point.x * (1 << kFractionBits)),
                        cvRound(point.y * (1 << kFractionBits)));
  }
  return points;
}

void paint_line(const LessonEdit::Line& line, int width, cv::Mat& canvas) {
  const auto points = fixed_point(line);
  // A line of one point is a dot, as wide as the stroke.
  for (std::size_t i = 0; i < points.size(); ++i)
    cv::line(canvas, points[i == 0 ? 0 : i - 1], points[i], cv::Scalar(255), width, cv::LINE_8,
             kFractionBits);
}

void paint_area(const LessonEdit::Line& line, cv::Mat& canvas) {
  const auto points = fixed_point(line);
  if (points.size() < 3)
    throw LessonEnded(LearnError::kRegionInvalid, "A painted area has fewer than three corners.");
  cv::fillPoly(canvas, std::vector<std::vector<cv::Point>>{points}, cv::Scalar(255), cv::LINE_8,
               kFractionBits);
}

std::size_t points_of(const std::vector<LessonEdit::Line>& lines) {
  std::size_t points = lines.size();
  for (const auto& line : lines) points += line.size();
  return points;
}

// A stroke that paints nothing is refused, because the operator would assume an effect.
void require_within(const LessonEdit::Line& line, double width, const cv::Size& image) {
  if (line.empty()) return;
  const auto [left, right] = std::minmax_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  const auto [top, bottom] = std::minmax_element(
      line.begin(), line.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
  const double reach = std::max(0.5, width / 2);
  if (right->x < -reach || left->x > image.width - 1 + reach || bottom->y < -reach ||
      top->y > image.height - 1 + reach)
    throw LessonEnded(LearnError::kRegionInvalid, kOutside, point_inside(image));
}

cv::Mat canvas_of(const std::vector<LessonEdit::Line>& lines, double width, const cv::Size& size) {
  cv::Mat canvas = cv::Mat::zeros(size, CV_8UC1);
  for (const auto& line : lines) {
    require_within(line, width, size);
    if (width == 0)
      paint_area(line, canvas);
    else
      paint_line(line, std::max(1, cvRound(width)), canvas);
  }
  return canvas;
}

}  // namespace

Marks painted(const Marks& marks, const LessonEdit& edit, const cv::Size& image) {
  if (edit.include.empty() && edit.exclude.empty()) return marks;
  if (!(edit.stroke_width >= 0 && edit.stroke_width <= kWidestStroke))
    throw LessonEnded(LearnError::kRegionInvalid,
                      "The stroke width must be 0 (closed areas) to 1000 pixels.");
  if (points_of(edit.include) + points_of(edit.exclude) > kMostPoints)
    throw LessonEnded(LearnError::kRegionInvalid, "The strokes have more than 4096 points.");
  Marks result;
  result.exclude = canvas_of(edit.exclude, edit.stroke_width, image);
  result.include = canvas_of(edit.include, edit.stroke_width, image) & ~result.exclude;
  if (marks.empty()) return result;
  const cv::Mat older = ~(result.include | result.exclude);
  return {result.include | (marks.include & older), result.exclude | (marks.exclude & older)};
}

cv::Mat overpainted(const cv::Mat& map, const Marks& marks) {
  if (marks.empty()) return map;
  return (map | marks.include) & ~marks.exclude;
}

}  // namespace mbncc::teaching
