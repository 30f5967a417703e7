// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/drawing.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <sstream>
#include <stdexcept>

namespace mbncc {
namespace {

constexpr int kShift = 4;  // OpenCV's sub-pixel bits
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
// Vermilion and bluish green from Okabe and Ito's palette.
const cv::Scalar kXColour(0, 94, 213), kYColour(115, 158, 0), kShade(0, 0, 0);

// Strokes and letters that remain legible when the image is scaled down to a third.
struct Pen {
  explicit Pen(const cv::Mat& image)
      : stroke(std::max(1, cvRound(image.cols / 320.0))),
        axis(std::max(30.0, image.cols / 16.0)),
        letters(std::clamp(image.cols / 700.0, 0.4, 4.0)) {}

  int stroke;      // [px]
  double axis;     // [px]
  double letters;  // OpenCV's font scale
};

// OpenCV draws with fixed-point coordinates; distant points are clamped to avoid overflow.
cv::Point fixed_point(cv::Point2d point) {
  const auto bounded = [](double v) { return std::clamp(v, -30000.0, 30000.0) * (1 << kShift); };
  return {cvRound(bounded(point.x)), cvRound(bounded(point.y))};
}

// Drawn dark and wide first, then in colour, so that it is visible on any background.
void draw_outline(cv::Mat& image, const std::vector<cv::Point2f>& outline, const cv::Scalar& colour,
                  const Pen& pen) {
  std::vector<cv::Point> corners;
  for (const auto& corner : outline) corners.push_back(fixed_point(corner));
  if (corners.empty()) return;
  cv::polylines(image, corners, true, kShade, pen.stroke + 2, cv::LINE_AA, kShift);
  cv::polylines(image, corners, true, colour, pen.stroke, cv::LINE_AA, kShift);
}

void draw_line(cv::Mat& image, const Pose2D& pose, cv::Point2d from, cv::Point2d to,
               const cv::Scalar& colour, const Pen& pen) {
  cv::line(image, fixed_point(transform(pose, from)), fixed_point(transform(pose, to)), colour,
           pen.stroke + 1, cv::LINE_AA, kShift);
}

// The x axis has an arrowhead, so that the axes differ by more than their colour.
void draw_axes(cv::Mat& image, const Pose2D& pose, const Pen& pen) {
  const double head = pen.axis / 4;
  draw_line(image, pose, {0, 0}, {0, pen.axis}, kYColour, pen);
  draw_line(image, pose, {0, 0}, {pen.axis, 0}, kXColour, pen);
  draw_line(image, pose, {pen.axis - head, -head}, {pen.axis, 0}, kXColour, pen);
  draw_line(image, pose, {pen.axis - head, head}, {pen.axis, 0}, kXColour, pen);
}

cv::Rect2d extent_of(const Marking& marking) {
  cv::Rect2d extent(marking.pose.position(), cv::Size2d(1, 1));
  for (const auto& outline : marking.outlines)
    if (!outline.empty()) extent |= cv::Rect2d(cv::boundingRect(outline));
  return extent;
}

// The caption's background, above the outline, or below it if there is no space.
cv::Rect plate_of(const Marking& marking, const cv::Size& text, const cv::Size& image) {
  const cv::Rect2d extent = extent_of(marking);
  const int gap = text.height / 2;
  const double above = extent.y - gap - text.height;
  const double wanted = above >= 0 ? above : extent.br().y + gap;
  const auto within = [](double v, int high) {
    return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(std::max(0, high))));
  };
  return {within(extent.x + extent.width / 2 - text.width / 2.0, image.width - text.width),
          within(wanted, image.height - text.height), text.width, text.height};
}

std::vector<std::string> lines_of(const std::string& caption) {
  std::vector<std::string> lines;
  std::istringstream text(caption);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

int width_of(const std::string& line, const Pen& pen) {
  int baseline = 0;
  return cv::getTextSize(line, kFont, pen.letters, pen.stroke, &baseline).width;
}

// Long names are shortened in the middle, so that the text after them, such as a verdict, stays
// visible.
std::string shortened(const std::string& line, int width, const Pen& pen) {
  std::string kept = line;
  for (std::size_t letters = line.size(); letters > 2 && width_of(kept, pen) > width; --letters)
    kept = line.substr(0, letters / 2) + ".." + line.substr(line.size() - (letters - letters / 2));
  return kept;
}

void draw_caption(cv::Mat& image, const Marking& marking, const Pen& pen) {
  std::vector<std::string> lines = lines_of(marking.caption);
  if (lines.empty()) return;
  const int border = 2 * pen.stroke;
  for (auto& line : lines) line = shortened(line, image.cols - 2 * border, pen);
  int baseline = 0, width = 0, height = 0;
  for (const auto& line : lines) {
    const cv::Size letters = cv::getTextSize(line, kFont, pen.letters, pen.stroke, &baseline);
    width = std::max(width, letters.width);
    height = std::max(height, letters.height);
  }
  const int line_height = height + baseline;
  const cv::Size text(width + 2 * border, line_height * static_cast<int>(lines.size()) + border);
  const cv::Rect plate = plate_of(marking, text, image.size());
  cv::rectangle(image, plate, marking.colour, cv::FILLED);
  cv::Point at = plate.tl() + cv::Point(border, border + height);
  for (const auto& line : lines) {
    cv::putText(image, line, at, kFont, pen.letters, kShade, pen.stroke, cv::LINE_AA);
    at.y += line_height;
  }
}

Confidence confidence_of(Verdict verdict) {
  if (verdict == Verdict::kGood) return Confidence::kGood;
  return verdict == Verdict::kMarginal ? Confidence::kDoubtful : Confidence::kBad;
}

}  // namespace

cv::Scalar colour_of(Confidence confidence) {
  switch (confidence) {
    case Confidence::kGood:
      return {233, 180, 86};
    case Confidence::kDoubtful:
      return {0, 159, 230};
    case Confidence::kBad:
      return {0, 94, 213};
    case Confidence::kUnsure:
      return {200, 200, 200};
  }
  return {200, 200, 200};
}

cv::Mat draw_markings(const cv::Mat& image, const std::vector<Marking>& markings) {
  if (image.empty() || (image.type() != CV_8UC1 && image.type() != CV_8UC3))
    throw std::invalid_argument("markings are drawn on 8-bit grey or colour images");
  cv::Mat drawn = image.clone();
  if (image.type() == CV_8UC1) cv::cvtColor(image, drawn, cv::COLOR_GRAY2BGR);
  const Pen pen(drawn);
  for (const auto& marking : markings) {
    for (const auto& outline : marking.outlines) draw_outline(drawn, outline, marking.colour, pen);
    draw_axes(drawn, marking.pose, pen);
  }
  // Captions are drawn last, so that no outline crosses them.
  for (const auto& marking : markings) draw_caption(drawn, marking, pen);
  return drawn;
}

Marking marking_of(const View& view, const Quality& quality, const std::string& caption) {
  Marking marking;
  for (const auto& outline : outlines(view)) {
    auto& placed = marking.outlines.emplace_back();
    for (const auto& point : outline) placed.emplace_back(transform(view.reference, point));
  }
  marking.pose = view.reference;
  marking.colour = colour_of(confidence_of(quality.verdict));
  marking.caption = caption;
  return marking;
}

}  // namespace mbncc
