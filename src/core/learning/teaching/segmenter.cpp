// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/segmenter.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "learning/likelihood/predicted_platform.hpp"
#include "learning/segmentation/clean_map.hpp"
#include "learning/segmentation/cut_evidence.hpp"
#include "learning/segmentation/map_measures.hpp"
#include "learning/segmentation/unconfirmed_hole.hpp"
#include "mbncc/learning/change_cut.hpp"
#include "mbncc/learning/region_cut.hpp"
#include "mbncc/learning/sb_grabcut.hpp"

namespace mbncc::teaching {
namespace {

constexpr double kSameObject = 0.5;  // least IoU of two cuts that show one object
constexpr int kBeside = 7;           // [px] square around a map pixel; change inside it is its rim
constexpr double kClearer = 0.02;  // least gain in the part of an outline that lies on image edges

// The cuts are the middle part of a lesson's progress.
double segment_progress(int iteration, int iterations) {
  return 0.2 + 0.6 * iteration / iterations;
}

// `earlier` cuts of `all` were reported before.
BeforeCut report_cuts(LessonProgress& progress, int earlier, int all) {
  return [&progress, earlier, all](int iteration) {
    const int number = earlier + iteration;
    progress.report(Stage::kSegment, segment_progress(number, all),
                    "Segmenting the object, round " + std::to_string(number + 1) + " of " +
                        std::to_string(all) + ".");
  };
}

BeforeCut report_cuts(const LearningConfig& config, LessonProgress& progress) {
  return report_cuts(progress, 0, config.iterations);
}

// One round of GrabCut with colours around the map and the marks.
cv::Mat grabcut_again(const cv::Mat& map, const Marks& marks, const SegmentationTask& task) {
  const cv::Rect room = task.region | cv::boundingRect(marks.include);
  const cv::Rect crop = grabcut_crop(room, map.size());
  cv::Mat labels(map.size(), CV_8UC1, cv::Scalar(cv::GC_BGD));
  labels(room).setTo(cv::GC_PR_BGD);
  labels.setTo(cv::GC_PR_FGD, map);
  labels.setTo(cv::GC_FGD, marks.include);
  labels.setTo(cv::GC_BGD, marks.exclude);
  cv::Mat result = cv::Mat::zeros(map.size(), CV_8UC1);
  repeatable_grabcut(task.before(crop), labels(crop), 1).copyTo(result(crop));
  return overpainted(segmentation::clean_map(result), marks);
}

// Completes `evidence` by the measures that need only the map and the marks that led to it.
Segmentation by_colours(const cv::Mat& map, CutEvidence evidence, const SegmentationTask& task,
                        const Marks& marks = {}) {
  const auto cut_again = [map, evidence, task](const Marks& further) {
    return by_colours(grabcut_again(map, further, task), evidence, task, further);
  };
  cv::Mat inside = cv::Mat::zeros(map.size(), CV_8UC1);
  inside(task.region).setTo(255);
  if (!marks.empty()) inside |= marks.include;
  evidence.region_touch = segmentation::region_touch(map, inside);
  evidence.region_span = segmentation::region_span(map, inside);
  evidence.cut_off = std::min(evidence.cut_off, evidence.region_touch);
  evidence.unconfirmed_hole =
      std::min(evidence.unconfirmed_hole, segmentation::enclosed_part(map, marks.exclude));
  return {map, evidence, cut_again, {}};
}

// A part of the object with other colours and a hole look the same in a map; a hole shows the
// platform, as the region's surroundings predict it.
double unconfirmed_hole_of(const cv::Mat& map, const SegmentationTask& task) {
  if (segmentation::enclosed_part(map, cv::Mat()) == 0) return 0;
  const alignment::AlignedPair pair = likelihood::predict_platform(task.before, task.region);
  return segmentation::unconfirmed_hole(map(pair.window), pair.before, pair.after, cv::Mat());
}

// Colours alone measure only whether holes show the platform.
Segmentation unverified(const cv::Mat& raw, const SegmentationTask& task) {
  const cv::Mat map = segmentation::clean_map(raw);
  CutEvidence evidence;
  evidence.verified = false;
  evidence.unconfirmed_hole = unconfirmed_hole_of(map, task);
  return by_colours(map, evidence, task);
}

Segmentation by_sb_grabcut(const SegmentationTask& task, const LearningConfig& config,
                           LessonProgress& progress) {
  return unverified(
      sb_grabcut(task.before, task.region, task.approximate, config.superpixel_method,
                 config.superpixels, config.iterations, report_cuts(config, progress)),
      task);
}

Segmentation by_grabcut_rect(const SegmentationTask& task, const LearningConfig& config,
                             LessonProgress& progress) {
  return unverified(
      grabcut_rect(task.before, task.region, config.iterations, report_cuts(config, progress)),
      task);
}

Segmentation by_grabcut_mask(const SegmentationTask& task, const LearningConfig& config,
                             LessonProgress& progress) {
  return unverified(grabcut_mask(task.before, task.region, task.approximate, config.iterations,
                                 report_cuts(config, progress)),
                    task);
}

Segmentation segmentation_of(const ObjectCut& cut) {
  Segmentation result{cut.map, cut.evidence, {}, {}};
  if (!cut.cut_again) return result;
  result.cut_again = [cut](const Marks& marks) {
    Segmentation again = segmentation_of(cut.cut_again(marks.include, marks.exclude));
    again.map = overpainted(again.map, marks);
    return again;
  };
  result.cut_with = [cut](const cv::Mat& preference) {
    return segmentation_of(cut.cut_with(preference));
  };
  return result;
}

// Part of the outline on image edges, the region's own edge excluded.
double edge_part(const Segmentation& found, const SegmentationTask& task) {
  return segmentation::edge_agreement(task.before, found.map) - found.evidence->region_touch;
}

// Part of the outline on image edges, and how far the map spans a drawn region: a much smaller one
// shows a part of the object.
double edge_and_span(const Segmentation& found, const SegmentationTask& task) {
  const double edges = segmentation::edge_agreement(task.before, found.map);
  if (task.least_span == 0) return edges;
  return edges + std::min(1.0, found.evidence->region_span / task.least_span);
}

// Area of the change cut that lies outside `map` and its rim, relative to the area of `map`.
double left_out(const cv::Mat& change, const cv::Mat& map) {
  cv::Mat grown;
  cv::dilate(map, grown, cv::Mat::ones(kBeside, kBeside, CV_8U));
  return cv::countNonZero(change & ~grown) / std::max(1.0, double(cv::countNonZero(map)));
}

// GrabCut's `map` with the evidence of the change cut. Strokes change both.
Segmentation with_evidence_of(const Segmentation& change, const cv::Mat& map,
                              const SegmentationTask& task, const Marks& marks = {}) {
  CutEvidence evidence = *change.evidence;
  evidence.stability = std::min(evidence.stability, segmentation::map_iou(change.map, map));
  evidence.change_beside = std::max(evidence.change_beside, left_out(change.map, map));
  Segmentation result = by_colours(map, evidence, task, marks);
  result.cut_again = [change, map, task](const Marks& further) {
    return with_evidence_of(change.cut_again(further), grabcut_again(map, further, task), task,
                            further);
  };
  return result;
}

// A map that reaches the edge of its region contains a shadow or a reflection, or the region cuts
// the object off. GrabCut, initialised with the change, replaces it if the two mostly agree and
// GrabCut's outline is clearer (docs/decisions/0005-change-cut.md).
Segmentation clearer_at_region_edge(const Segmentation& change, const SegmentationTask& task,
                                    int rounds, const BeforeCut& before_cut) {
  if (change.evidence->region_touch == 0) return change;
  const cv::Mat map = segmentation::clean_map(
      grabcut_mask(task.before, task.region, task.approximate, rounds, before_cut));
  if (segmentation::map_iou(change.map, map) < kSameObject) return change;
  Segmentation colours = with_evidence_of(change, map, task);
  if (edge_part(colours, task) < edge_part(change, task) + kClearer) return change;
  // Another view changes the cut, so the two are compared again.
  colours.cut_with = [with = change.cut_with, task, rounds](const cv::Mat& preference) {
    return clearer_at_region_edge(with(preference), task, rounds, {});
  };
  return colours;
}

Segmentation by_change_cut(const SegmentationTask& task, const LearningConfig& config,
                           LessonProgress& progress) {
  if (task.after.empty())
    throw LessonEnded(LearnError::kNoImage, "The method change_cut needs an image after.");
  const ObjectCut cut =
      change_cut(task.before, task.after, task.region, task.changed, config.iterations,
                 config.max_shift, report_cuts(config, progress));
  return segmentation_of(cut);
}

Segmentation by_change(const SegmentationTask& task, const LearningConfig& config,
                       LessonProgress& progress) {
  const Segmentation cut = by_change_cut(task, config, progress);
  if (!cut.cut_again || cut.evidence->region_touch > task.largest_touch) return cut;
  const int rounds = config.iterations;
  return clearer_at_region_edge(cut, task, rounds, report_cuts(progress, rounds, 2 * rounds));
}

Segmentation region_cut_of(const SegmentationTask& task, int iterations,
                           const BeforeCut& before_cut) {
  Segmentation result =
      segmentation_of(region_cut(task.before, task.region, iterations, before_cut));
  result.cut_with = nullptr;
  return result;
}

Segmentation by_region_cut(const SegmentationTask& task, const LearningConfig& config,
                           LessonProgress& progress) {
  return region_cut_of(task, config.iterations, report_cuts(config, progress));
}

// `chosen`, as stable as it agrees with the cut of the other method, after strokes as well.
Segmentation compared(Segmentation chosen, const Segmentation& other) {
  chosen.evidence->stability = segmentation::map_iou(chosen.map, other.map);
  if (!chosen.cut_again) return chosen;
  chosen.cut_again = [again = chosen.cut_again, other](const Marks& marks) {
    if (other.cut_again) return compared(again(marks), other.cut_again(marks));
    Segmentation painted = other;
    painted.map = overpainted(other.map, marks);
    return compared(again(marks), painted);
  };
  return chosen;
}

// One image does not show whether the platform is one smooth surface, which the region cut
// assumes, or many colours, which GrabCut learns: the cut with the clearer outline is right more
// often. Where the two disagree, the map is uncertain (docs/decisions/0008-region-cut.md).
Segmentation by_clearer_outline(const SegmentationTask& task, const LearningConfig& config,
                                LessonProgress& progress) {
  const int rounds = config.iterations;
  const Segmentation smooth = region_cut_of(task, rounds, report_cuts(progress, 0, 2 * rounds));
  const Segmentation colours = unverified(
      grabcut_rect(task.before, task.region, rounds, report_cuts(progress, rounds, 2 * rounds)),
      task);
  const double lead = edge_and_span(smooth, task) - edge_and_span(colours, task);
  const double touches_more = smooth.evidence->region_touch - colours.evidence->region_touch;
  const auto clearer = [&](double touch_weight) {
    return lead >= touch_weight * touches_more ? compared(smooth, colours)
                                               : compared(colours, smooth);
  };
  // In a tight region, a map of the whole object reaches the edge, but a map of a part does not.
  const Segmentation filling = clearer(0);
  return filling.evidence->region_touch > task.largest_touch ? filling : clearer(1);
}

}  // namespace

Segmenter segmenter_of(const std::string& method, bool has_after) {
  if (method == "auto") return has_after ? by_change : by_clearer_outline;
  if (method == "change_cut") return by_change_cut;
  if (method == "region_cut") return by_region_cut;
  if (method == "sb_grabcut") return by_sb_grabcut;
  if (method == "grabcut_rect") return by_grabcut_rect;
  if (method == "grabcut_mask") return by_grabcut_mask;
  throw std::invalid_argument("unknown learning method '" + method + "'");
}

}  // namespace mbncc::teaching
