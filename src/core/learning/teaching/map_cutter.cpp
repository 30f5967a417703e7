// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/map_cutter.hpp"

#include <algorithm>

#include "imaging/rectangles.hpp"
#include "learning/change/platform_likeness.hpp"
#include "learning/segmentation/cut_evidence.hpp"
#include "learning/segmentation/map_measures.hpp"
#include "learning/teaching/click_region.hpp"
#include "learning/teaching/lesson_region.hpp"
#include "learning/teaching/stage_images.hpp"
#include "learning/teaching/step_timer.hpp"

namespace mbncc::teaching {
namespace {

constexpr int kClickMargin = 6;      // [px] least margin around the clicked piece
constexpr double kClickPart = 0.15;  // the margin as a part of the piece's longer side
constexpr double kTouching = 0.04;   // part of the outline on the region's edge; if more, it grows
constexpr double kTight = 0.35;  // part of the outline on a drawn region's edge; if more, it grows
constexpr double kNearlySame = 0.9;  // least IoU of the maps of a drawn and of a wider region
constexpr double kLeastSpan = 0.6;   // part of a drawn region's sides that the object fills
constexpr int kLeastTolerance = 2;   // [px] by which a drawn region may be too small on every side
constexpr double kTolerance = 0.08;  // the tolerance as a part of the region's width and height
constexpr double kClear = 0.8;       // least boundary contrast and stability of clear edges
constexpr double kAlike = 0.35;      // platform_likeness() above which a map is mostly platform
constexpr double kFullPart = 0.98;   // part of the room from which a map is full

// Whether a map without a clear edge looks like the platform, because more than the object changed.
bool is_mostly_platform(const Segmentation& found, const SegmentationTask& task) {
  return found.evidence && found.evidence->boundary_contrast < kClear &&
         change::platform_likeness(task.before, task.after, found.map) > kAlike;
}

bool has_clear_edge(const Segmentation& found) {
  return !found.evidence || segmentation::edge_clarity(*found.evidence) >= kClear;
}

// A map that the user painted.
void check_given_map(const cv::Mat& map) {
  const int filled = cv::countNonZero(map);
  require(filled > 0, LearnError::kSegmentationEmpty, "The map is black everywhere.",
          "Paint the object white.");
  require(filled < kFullPart * static_cast<double>(map.total()), LearnError::kSegmentationFull,
          "The map is white nearly everywhere.", "Paint everything but the object black.");
}

// `room` is the area that the map could have filled.
void check_map(const cv::Mat& map, const cv::Rect& room) {
  const int filled = cv::countNonZero(map);
  if (filled == 0) throw LessonEnded(LearnError::kSegmentationEmpty);
  if (filled >= kFullPart * room.area()) throw LessonEnded(LearnError::kSegmentationFull);
}

// Includes `hole` in every further cut, until a stroke excludes a part of it.
Segmentation including(const cv::Mat& hole, Segmentation cut) {
  if (cut.cut_again) {
    cut.cut_again = [hole, again = cut.cut_again](const Marks& marks) {
      if (cv::countNonZero(marks.exclude & hole) > 0) return again(marks);
      return again({marks.include | hole, marks.exclude});
    };
  }
  if (cut.cut_with) {
    cut.cut_with = [hole, with = cut.cut_with](const cv::Mat& preference) {
      return including(hole, with(preference));
    };
  }
  return cut;
}

// The pieces of a cut with a pixel of `seed`, and of further cuts those with a pixel of its map or
// of a stroke: other pieces are neighbours that left as well.
Segmentation only_with(const cv::Mat& seed, Segmentation cut) {
  cut.map = pieces_with(cut.map, seed);
  if (cut.cut_again) {
    cut.cut_again = [map = cut.map, again = cut.cut_again](const Marks& marks) {
      return only_with((map & ~marks.exclude) | marks.include, again(marks));
    };
  }
  if (cut.cut_with) {
    cut.cut_with = [map = cut.map, with = cut.cut_with](const cv::Mat& preference) {
      return only_with(map, with(preference));
    };
  }
  return cut;
}

// A cut that is as stable as `agreement` at most, after strokes as well.
Segmentation limited_by(double agreement, Segmentation cut) {
  if (cut.evidence) cut.evidence->stability = std::min(cut.evidence->stability, agreement);
  if (cut.cut_again) {
    cut.cut_again = [agreement, again = cut.cut_again](const Marks& marks) {
      return limited_by(agreement, again(marks));
    };
  }
  return cut;
}

template <class Steps>
std::optional<Segmentation> if_possible(Steps&& steps) {
  try {
    return steps();
  } catch (const LessonEnded& ended) {
    if (ended.error() == LearnError::kCancelled) throw;
    return std::nullopt;
  }
}

}  // namespace

MapCutter::MapCutter(const Lesson& lesson, const LearningConfig& config, LessonProgress& progress,
                     std::map<std::string, double>& timings_ms)
    : lesson_(lesson), config_(config), progress_(progress), timings_ms_(timings_ms) {}

// A given map is used unchanged, and so is an outline unless a method for its refinement is given.
Segmentation MapCutter::acquire_map() {
  if (!lesson_.map.empty()) {
    check_given_map(lesson_.map > 127);
    return accept(lesson_.map > 127);
  }
  if (!lesson_.outline.empty() && config_.method == "auto") return accept(outline_map(lesson_));
  mark_region();
  return segment(Growth::kMayGrow);
}

Segmentation MapCutter::accept(const cv::Mat& map) {
  check_map(map, {{0, 0}, map.size()});
  progress_.report(Stage::kRegion, 0.1, "Using the given map.",
                   [&] { return outlined(lesson_.before, map); });
  return {map, std::nullopt, {}, {}};
}

void MapCutter::mark_region() {
  const StepTimer timer(timings_ms_, "region");
  const RegionOfLesson region = region_of(lesson_, config_);
  task_ = {lesson_.before, lesson_.after, region.room, region.approximate, region.surveyed};
  departed_ = region.changed;
  agreement_ = region.agreement;
  second_departure_ = region.second_departure;
  progress_.report(Stage::kRegion, 0.1, "Marking the approximate region.",
                   [&] { return tinted(task_.before, task_.approximate, task_.region); });
}

void MapCutter::set_place(const cv::Rect& place) {
  task_.region = place;
}

Segmentation MapCutter::segment(Growth growth) {
  return lesson_.click ? segment_clicked(growth) : segment_region(growth);
}

Segmentation MapCutter::segment_region(Growth growth) {
  const cv::Rect wider = growth == Growth::kMayGrow ? wider_region() : task_.region;
  if (wider == task_.region) return segment_once();
  const bool drawn = lesson_.region != cv::Rect() && task_.region == usable_region(lesson_);
  if (drawn) return segment_drawn_region(wider);
  const Segmentation found = segment_unless_touching(std::min(kTouching, task_.largest_touch));
  if (!found.evidence || found.evidence->region_touch <= kTouching) return checked(found);
  task_.region = wider;
  return segment_once();
}

// A drawn region grows if it is tight, or if the object may continue outside it and the wider map
// is nearly the same; a wider map that differs more may contain a shadow.
Segmentation MapCutter::segment_drawn_region(const cv::Rect& wider) {
  const cv::Rect drawn = task_.region;
  const Segmentation found = segment_unless_touching(kTight);
  if (!found.evidence) return checked(found);
  const bool tight = found.evidence->region_touch > kTight;
  if (!tight && found.evidence->cut_off <= kTouching) return checked(found);
  task_.region = wider;
  const auto grown = if_possible([&] { return segment_once(); });
  if (grown && (tight || segmentation::map_iou(grown->map, found.map) > kNearlySame)) return *grown;
  task_.region = drawn;
  return tight ? segment_once() : checked(found);
}

// For a click in one image, stability includes that the map does not depend on the region's size.
Segmentation MapCutter::segment_clicked_piece() {
  return limited_by(agreement_, clicked(segment_once()));
}

Segmentation MapCutter::segment_clicked(Growth growth) {
  if (task_.after.empty()) return segment_clicked_piece();
  return with_clicked_hole(segment_clicked_change(growth));
}

// GrabCut is slow in the large regions in which the clicked object is looked for, so that it is
// compared only in the last one.
Segmentation MapCutter::segment_clicked_change(Growth growth) {
  task_.largest_touch = 0;
  Segmentation found = find_clicked(growth);
  task_.largest_touch = 1;
  if (!found.evidence || found.evidence->region_touch == 0) return found;
  const Segmentation compared = segment_once();
  const cv::Mat piece = piece_at(compared.map, *lesson_.click);
  return cv::countNonZero(piece) > 0 ? only_with(piece, compared) : found;
}

// Where the platform changed as well, the change around a click contains more than the object.
Segmentation MapCutter::find_clicked(Growth growth) {
  try {
    const Segmentation found = clicked(segment_region(growth));
    return is_mostly_platform(found, task_) ? segment_square().value_or(found) : found;
  } catch (const LessonEnded& ended) {
    if (ended.error() == LearnError::kCancelled) throw;
    if (const auto found = segment_square()) return *found;
    throw;
  }
}

// Segments in the largest square around the click in which the map has a clear edge.
std::optional<Segmentation> MapCutter::segment_square() {
  const SegmentationTask first = task_;
  const double largest = std::max(first.region.width, first.region.height);
  for (const cv::Rect& square : squares_about(*lesson_.click, largest, usable_region(lesson_))) {
    task_.region = square;
    const auto found = if_possible([&] { return clicked(segment_once()); });
    if (found && has_clear_edge(*found)) return found;
  }
  task_ = first;
  return std::nullopt;
}

// A click selects one connected object: neighbours that were also removed are excluded by a
// narrower region.
Segmentation MapCutter::clicked(const Segmentation& found) {
  const cv::Mat piece = piece_at(found.map, *lesson_.click);
  if (cv::countNonZero(piece) == 0) refuse_click();
  check_map(piece, task_.region);
  if (cv::countNonZero(piece) == cv::countNonZero(found.map)) return found;
  const cv::Rect box = cv::boundingRect(piece);
  const int margin =
      std::max(kClickMargin, static_cast<int>(kClickPart * std::max(box.width, box.height)));
  task_.region = imaging::grown(box, margin) & usable_region(lesson_);
  const Segmentation alone = segment_once();
  const cv::Mat clicked_piece = piece_at(alone.map, *lesson_.click);
  check_map(clicked_piece, task_.region);
  return only_with(clicked_piece, alone);
}

// A click is a point on the object. Where the object has the platform's colour there, its rim alone
// is cut out, so the hole is included like a stroke.
Segmentation MapCutter::with_clicked_hole(const Segmentation& found) {
  const cv::Mat hole = hole_at(found.map, *lesson_.click);
  if (cv::countNonZero(hole) == 0) return found;
  Segmentation filled = cut_again(found, {hole, cv::Mat::zeros(hole.size(), CV_8UC1)});
  filled.cut_again = found.cut_again;
  return including(hole, filled);
}

std::optional<Segmentation> MapCutter::segment_if_possible(Growth growth) {
  return if_possible([&] { return segment(growth); });
}

Segmentation MapCutter::segment_once() {
  return checked(segment_unless_touching(task_.largest_touch));
}

Segmentation MapCutter::segment_unless_touching(double largest_touch) {
  const StepTimer timer(timings_ms_, "segment");
  SegmentationTask task = task_;
  task.largest_touch = largest_touch;
  if (lesson_.region != cv::Rect() && !lesson_.click) task.least_span = kLeastSpan;
  return segmenter_of(config_.method, !task.after.empty())(task, config_, progress_);
}

Segmentation MapCutter::checked(const Segmentation& found) {
  check_map(found.map, task_.region);
  progress_.report(Stage::kSegment, 0.8, "The object is segmented.",
                   [&] { return outlined(task_.before, found.map); });
  return found;
}

// Regions drawn by hand may end at the object's edge or slightly inside it.
cv::Rect MapCutter::widest_region() const {
  const cv::Rect region = usable_region(lesson_);
  if (lesson_.region == cv::Rect()) return region;
  const auto tolerance = [](int length) {
    return std::max(kLeastTolerance, static_cast<int>(kTolerance * length));
  };
  const cv::Point margin(tolerance(region.width), tolerance(region.height));
  return cv::Rect(region.tl() - margin, region.br() + margin) &
         cv::Rect({0, 0}, lesson_.before.size());
}

// A region that was not drawn may be far too small, a drawn one only slightly.
cv::Rect MapCutter::wider_region() const {
  if (!lesson_.outline.empty()) return task_.region;
  const int margin = std::max(task_.region.width, task_.region.height) / 2;
  return imaging::grown(task_.region, margin) & widest_region();
}

Segmentation MapCutter::cut_again(const Segmentation& cut, const Marks& marks) {
  if (marks.empty()) return cut;
  const StepTimer timer(timings_ms_, "segment");
  progress_.report(Stage::kSegment, 0.2, "Segmenting the object again.");
  Segmentation segmentation = cut.cut_again
                                  ? cut.cut_again(marks)
                                  : Segmentation{overpainted(cut.map, marks), cut.evidence, {}, {}};
  check_map(segmentation.map, {{0, 0}, segmentation.map.size()});
  progress_.report(Stage::kSegment, 0.8, "The object is segmented.",
                   [&] { return outlined(lesson_.before, segmentation.map); });
  return segmentation;
}

}  // namespace mbncc::teaching
