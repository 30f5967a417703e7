// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/overlay.hpp"

#include <algorithm>
#include <cstdio>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "mbncc/drawing.hpp"
#include "mbncc/matching/overlay.hpp"
#include "nodelets/conversion/messages.hpp"

namespace mbncc::nodelets {

using mbncc_vision::DetectedObject;

namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kTextColour(255, 255, 255);

Confidence confidence_of(std::uint8_t state) {
  if (state == DetectedObject::CONFIRMED) return Confidence::kGood;
  return state == DetectedObject::AMBIGUOUS ? Confidence::kDoubtful : Confidence::kUnsure;
}

Marking marking_of(const DetectedObject& object) {
  char number[16], score[16];
  std::snprintf(number, sizeof number, " #%u", object.instance_id);
  std::snprintf(score, sizeof score, "\n%.2f ", object.score);
  Marking marking;
  auto& outline = marking.outlines.emplace_back();
  for (const auto& point : object.outline.points) outline.emplace_back(point.x, point.y);
  marking.pose = {object.image_pose.x, object.image_pose.y, object.image_pose.theta};
  marking.colour = colour_of(confidence_of(object.state));
  marking.caption = object.name + number + score + word_of(object.state);
  if (object.state == DetectedObject::AMBIGUOUS) marking.caption += brief_reason(object.reasons);
  return marking;
}

// Text style of the legend and the score map.
struct Letters {
  explicit Letters(double width)
      : size(std::clamp(width / 850, 0.25, 3.0)), stroke(static_cast<int>(width) / 640 + 1) {
    height = cv::getTextSize("X", kFont, size, stroke, &baseline).height;
  }
  int width_of(const std::string& text) const {
    int ignored = 0;
    return cv::getTextSize(text, kFont, size, stroke, &ignored).width;
  }
  void write(cv::Mat& image, const std::string& text, cv::Point at, const cv::Scalar& ink) const {
    cv::putText(image, text, at, kFont, size, ink, stroke, cv::LINE_AA);
  }

  double size;
  int stroke, height = 0, baseline = 0;
};

std::string age_of(const mbncc_vision::DetectedObjectArray& detections) {
  char text[48];
  std::snprintf(text, sizeof text, "%.2f s old", detections.latency);
  return text;
}

constexpr std::uint8_t kExplained[] = {DetectedObject::CONFIRMED, DetectedObject::AMBIGUOUS,
                                       DetectedObject::NEW};

/// Letters scaled so that the legend fits into the image's width.
Letters letters_of_legend(int width, const std::string& age) {
  const Letters letters(width);
  int needed = letters.width_of(age) + letters.height;
  for (const std::uint8_t state : kExplained)
    needed += letters.width_of(word_of(state)) + 5 * letters.height / 2;
  return needed <= width ? letters : Letters(double(width) * width / needed);
}

cv::Mat with_legend(const cv::Mat& image, const mbncc_vision::DetectedObjectArray& detections) {
  const std::string age = age_of(detections);
  const Letters letters = letters_of_legend(image.cols, age);
  const int line = 2 * letters.height;
  cv::Mat shown;
  cv::copyMakeBorder(image, shown, 0, line, 0, 0, cv::BORDER_CONSTANT, cv::Scalar::all(30));
  const int foot = shown.rows - line / 4;
  int x = letters.height / 2;
  for (const std::uint8_t state : kExplained) {
    const cv::Rect swatch(x, foot - letters.height, letters.height, letters.height);
    cv::rectangle(shown, swatch, colour_of(confidence_of(state)), cv::FILLED);
    x += 3 * letters.height / 2;
    letters.write(shown, word_of(state), {x, foot}, kTextColour);
    x += letters.width_of(word_of(state)) + letters.height;
  }
  const int right = shown.cols - letters.width_of(age) - letters.height / 2;
  letters.write(shown, age, {right, foot}, kTextColour);
  return shown;
}

struct Peak {
  double score = 0;
  cv::Point place;
};

Peak peak_of(const cv::Mat& scores, const cv::Mat& mask = {}) {
  Peak peak;
  cv::minMaxLoc(scores, nullptr, &peak.score, nullptr, &peak.place, mask);
  return peak;
}

/// Writes `text` beside the peak, or below or above `taken` if they would overlap. Returns the box
/// of the text.
cv::Rect name_peak(cv::Mat& image, const Peak& peak, const char* text, int radius,
                   const cv::Rect& taken = {}) {
  const Letters letters(2 * image.cols);
  const cv::Size size(letters.width_of(text), letters.height + letters.baseline);
  cv::Rect box({std::min(peak.place.x + radius + 4, image.cols - size.width - 2),
                std::max(peak.place.y - letters.height, 2)},
               size);
  if (!(box & taken).empty()) {
    box.y = taken.br().y + 2;
    if (box.br().y > image.rows) box.y = taken.y - 2 - size.height;
  }
  const cv::Point at(box.x, box.y + letters.height);
  Letters shade = letters;
  shade.stroke += 2;
  shade.write(image, text, at, cv::Scalar::all(0));
  letters.write(image, text, at, kTextColour);
  return box;
}

}  // namespace

cv::Mat draw_detections(const cv::Mat& image, const mbncc_vision::DetectedObjectArray& detections) {
  std::vector<Marking> markings;
  for (const auto& object : detections.objects) markings.push_back(marking_of(object));
  return with_legend(draw_markings(image, markings), detections);
}

cv::Mat colour_score_map(const cv::Mat& scores) {
  cv::Mat levels, coloured;
  scores.convertTo(levels, CV_8UC1, 255);
  cv::applyColorMap(levels, coloured, cv::COLORMAP_CIVIDIS);
  return coloured;
}

cv::Mat draw_score_map(const cv::Mat& scores, double radius) {
  cv::Mat drawn = colour_score_map(scores);
  const Peak best = peak_of(scores);
  if (best.score <= 0) return drawn;
  cv::Mat elsewhere(scores.size(), CV_8UC1, cv::Scalar(255));
  cv::circle(elsewhere, best.place, cvRound(radius), cv::Scalar(0), cv::FILLED);
  const Peak second = peak_of(scores, elsewhere);
  const int mark = std::max(6, drawn.cols / 25), stroke = drawn.cols / 320 + 1;
  cv::circle(drawn, best.place, mark, kTextColour, stroke, cv::LINE_AA);
  const cv::Rect label = name_peak(drawn, best, "object", mark);
  if (second.score <= 0) return drawn;
  const cv::Point half(mark, mark);
  cv::rectangle(drawn, second.place - half, second.place + half, kTextColour, stroke);
  name_peak(drawn, second, "next best", mark, label);
  return drawn;
}

}  // namespace mbncc::nodelets
