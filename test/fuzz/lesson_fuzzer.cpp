// SPDX-License-Identifier: BSD-3-Clause
// Requests of a lesson: name, region, outline, click, strokes and reference with arbitrary numbers,
// on a small image. A lesson must end with a model or a reason.
#include <cstring>

#include "fuzz/fuzzer.hpp"
#include "mbncc/learning/interactive_lesson.hpp"

using namespace mbncc;

namespace {

template <class Number>
Number number_from(fuzz::Pieces& pieces) {
  // Usually near the image, sometimes anywhere.
  const int kind = pieces.byte();
  if (kind < 200) return static_cast<Number>(kind - 20);
  Number number = 0;
  const std::string bytes = pieces.text(sizeof number);
  std::memcpy(&number, bytes.data(), bytes.size());
  return number;
}

template <class Point>
std::vector<Point> points_from(fuzz::Pieces& pieces) {
  std::vector<Point> points(pieces.byte() % 40);
  for (auto& point : points) {
    point.x = number_from<float>(pieces);
    point.y = number_from<float>(pieces);
  }
  return points;
}

cv::Mat image(bool with_object) {
  cv::Mat scene(48, 64, CV_8UC3);
  cv::RNG(1).fill(scene, cv::RNG::UNIFORM, 90, 120);
  if (with_object) scene(cv::Rect(20, 14, 24, 18)).setTo(cv::Scalar(30, 40, 200));
  return scene;
}

cv::Rect rectangle_from(fuzz::Pieces& pieces) {
  const int x = number_from<int>(pieces), y = number_from<int>(pieces);
  return {x, y, number_from<int>(pieces), number_from<int>(pieces)};
}

Lesson lesson_from(fuzz::Pieces& pieces) {
  const int ways = pieces.byte();
  Lesson lesson;
  lesson.name = (ways & 1) != 0 ? pieces.text(pieces.byte()) : "part";
  lesson.before = image(true);
  if ((ways & 2) != 0) lesson.after = image(false);
  if ((ways & 4) != 0) lesson.region = rectangle_from(pieces);
  if ((ways & 8) != 0) lesson.outline = points_from<cv::Point2f>(pieces);
  if ((ways & 16) != 0)
    lesson.click = cv::Point2d(number_from<double>(pieces), number_from<double>(pieces));
  if ((ways & 32) != 0)
    lesson.reference = Pose2D{number_from<double>(pieces), number_from<double>(pieces),
                              number_from<double>(pieces)};
  if ((ways & 64) != 0) lesson.object_height = number_from<double>(pieces);
  return lesson;
}

LessonEdit edit_from(fuzz::Pieces& pieces) {
  LessonEdit edit;
  edit.include = {points_from<cv::Point2f>(pieces)};
  edit.exclude = {points_from<cv::Point2f>(pieces)};
  edit.stroke_width = number_from<float>(pieces);
  if (pieces.byte() % 2 != 0) edit.region = rectangle_from(pieces);
  return edit;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Pieces pieces(data, size);
  InteractiveLesson lesson(lesson_from(pieces));
  const LearnResult first = lesson.result();
  if (first.has_model) validate(first.object);
  if (first.has_model && !pieces.empty()) {
    lesson.edit(edit_from(pieces));
    fuzz::planted_bug(size);
  }
  return 0;
}
