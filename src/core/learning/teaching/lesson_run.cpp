// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/lesson_run.hpp"

#include <algorithm>
#include <chrono>

#include "learning/segmentation/map_measures.hpp"
#include "learning/teaching/lesson_checks.hpp"
#include "learning/teaching/lesson_region.hpp"
#include "learning/teaching/map_cutter.hpp"
#include "learning/teaching/put_aside.hpp"
#include "learning/teaching/stage_images.hpp"
#include "learning/teaching/step_timer.hpp"
#include "mbncc/learning/quality.hpp"

namespace mbncc::teaching {
namespace {

constexpr double kRefines = 0.75;  // agreement of two views, above which both contribute to the map
constexpr double kCutOff = 0.1;    // part of an outline on the edge of a region that cuts it off

bool refines(const NewPlace& place) {
  return place.agreement >= kRefines;
}

// A cut before and after strokes. If several objects left (`second_departure`, or several large
// parts of the map), another one may be meant, unless a stroke includes a part of this one. One
// part may also be the place where the object was put down.
Segmentation doubtful(Segmentation cut, double second_departure) {
  if (!cut.evidence) return cut;
  cut.evidence->second_departure = large_parts(cut.map).empty() ? second_departure : 1;
  if (!cut.cut_again) return cut;
  cut.cut_again = [map = cut.map, again = cut.cut_again, second_departure](const Marks& marks) {
    const bool meant = cv::countNonZero(map & marks.include) > 0;
    return doubtful(again(marks), meant ? 0 : second_departure);
  };
  return cut;
}

class LessonRun {
 public:
  LessonRun(LessonState& state, const LearningConfig& config, const SearchConfig& search,
            const StageObserver& observer)
      : state_(state),
        lesson_(state.lesson),
        config_(config),
        search_(search),
        progress_(observer),
        result_(state.result),
        cutter_(lesson_, config_, progress_, result_.timings_ms) {}

  void learn() {
    check_lesson(lesson_);
    if (has_change_only()) {
      find_place();
    } else {
      acquire_map();
    }
    finish(*state_.cut);
  }

  void edit(const LessonEdit& edit) {
    state_.marks = painted(state_.marks, edit, lesson_.before.size());
    if (edit.reference) lesson_.reference = edit.reference;
    check_lesson(lesson_);
    if (edit.region != cv::Rect()) {
      point_at(edit.region);
      acquire_map();
    }
    finish(cutter_.cut_again(*state_.cut, state_.marks));
  }

 private:
  void acquire_map() {
    state_.cut = cutter_.acquire_map();
    keep_changed();
    search_put_aside();
    if (!lesson_.after.empty()) state_.cut = doubtful(*state_.cut, 0);
  }

  void keep_changed() {
    if (!cutter_.departed().empty()) state_.changed = cutter_.departed();
  }

  void finish(const Segmentation& segmentation) {
    make_model(segmentation.map);
    if (const auto& place = state_.new_place)
      result_.put_aside = PutAside{compose(place->motion, result_.object.views.front().reference),
                                   place->agreement, refines(*place)};
    judge(segmentation);
  }

  // An object put aside within the view is visible again, which gives a second estimate of the map.
  void search_put_aside() {
    state_.new_place.reset();
    if (!state_.cut->cut_with) return;
    const StepTimer timer(result_.timings_ms, "put_aside");
    make_model(state_.cut->map);
    state_.new_place = place_put_aside(state_.cut->map);
    if (!state_.new_place || !refines(*state_.new_place)) return;
    state_.cut = state_.cut->cut_with(state_.new_place->preference);
  }

  // New place of the object that was just modelled from `map`.
  std::optional<NewPlace> place_put_aside(const cv::Mat& map) const {
    return find_put_aside(result_.object, map, cutter_.task(), cutter_.surveyed(), config_,
                          search_);
  }

  bool has_change_only() const {
    return is_without_place(lesson_) && lesson_.map.empty() && lesson_.outline.empty();
  }

  // Without a given place, the change with the largest evidence is used, unless another change is
  // confirmed by finding its object elsewhere and this one is not.
  void find_place() {
    cutter_.mark_region();
    keep_changed();
    state_.cut = cutter_.segment_if_possible(Growth::kMayGrow);
    if (state_.cut && !state_.cut->cut_with) return;
    if (state_.cut) search_put_aside();
    if (state_.new_place || reconsider_place()) return;
    if (!state_.cut)
      state_.cut = cutter_.segment(Growth::kMayGrow);  // throws the reason why there is none
    state_.cut = doubtful(*state_.cut, cutter_.second_departure());
  }

  bool reconsider_place() {
    const SegmentationTask first = cutter_.task();
    const cv::Mat& tried = state_.cut ? state_.cut->map : first.approximate;
    const StepTimer timer(result_.timings_ms, "put_aside");
    for (const cv::Rect& place : large_parts(tried))
      if (learn_departure_at(place, Growth::kFixed)) return true;
    for (const cv::Rect& place : places_elsewhere(cutter_.surveyed(), tried))
      if (learn_departure_at(place, Growth::kMayGrow)) return true;
    cutter_.set_task(first);
    return false;
  }

  // Learns the object at `place` if it left from there and is found elsewhere now.
  bool learn_departure_at(const cv::Rect& place, Growth growth) {
    cutter_.set_place(place);
    const std::optional<Segmentation> other = cutter_.segment_if_possible(growth);
    if (!other || !other->cut_with) return false;
    make_model(other->map);
    const auto found = place_put_aside(other->map);
    if (!found) return false;
    state_.changed = cutter_.surveyed();
    state_.new_place = found;
    state_.cut = refines(*found) ? other->cut_with(found->preference) : *other;
    return true;
  }

  // From here on, the lesson uses this region.
  void point_at(const cv::Rect& region) {
    lesson_.region = region;
    lesson_.map = cv::Mat();
    lesson_.outline.clear();
    lesson_.click.reset();
    if (lesson_.after.empty() && config_.method == "change_cut")
      throw LessonEnded(LearnError::kNoImage, "The method change_cut needs an image after.");
  }

  void make_model(const cv::Mat& map) {
    if (map.data == modelled_.data) return;
    modelled_ = map;
    const cv::Point2d centre = centroid(map);
    const Pose2D reference = lesson_.reference.value_or(Pose2D{centre.x, centre.y, 0});
    ObjectModel& object = result_.object;
    object.name = lesson_.name;
    object.label = lesson_.label.empty() ? lesson_.name : lesson_.label;
    object.object_height = lesson_.object_height;
    object.symmetry = lesson_.symmetry;
    object.learned_at =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    object.views = {crop_view(lesson_.before, map, reference)};
  }

  void judge(const Segmentation& segmentation) {
    const StepTimer timer(result_.timings_ms, "quality");
    progress_.report(Stage::kQuality, 0.85, "Computing the verdict.");
    result_.evidence = segmentation.evidence;
    if (result_.evidence && !lesson_.after.empty())
      result_.evidence->edges_after =
          segmentation::edges_only_after(lesson_.before, lesson_.after, segmentation.map);
    Quality& quality = result_.object.quality;
    quality = assess_quality(result_.object, lesson_.before, state_.changed, result_.evidence,
                             config_, search_);
    // A given map is never refused for quality; the verdict only warns.
    if (!lesson_.map.empty() && quality.verdict == Verdict::kBad)
      quality.verdict = Verdict::kMarginal;
    result_.has_model = true;
    progress_.report(Stage::kQuality, 1, "Verdict computed.",
                     [&] { return outlined(lesson_.before, segmentation.map); });
    conclude(error_of(quality));
  }

  bool region_reaches_out() const {
    const cv::Rect& region = lesson_.region;
    const cv::Rect2d given(region.x, region.y, region.width, region.height);
    const cv::Rect2d image({0, 0}, cv::Size2d(lesson_.before.size()));
    return region != cv::Rect() && (given & image) != given;
  }

  // In one image nothing shows how far the object reaches beyond the region.
  bool may_be_cut_off() const {
    return lesson_.region != cv::Rect() && lesson_.after.empty() && result_.evidence &&
           result_.evidence->region_touch > kCutOff;
  }

  // In one image a click beside the object cuts out the platform.
  bool took_the_platform() const { return lesson_.click && lesson_.after.empty(); }

  void conclude(LearnError error) {
    if (error == LearnError::kTouchesBorder && region_reaches_out()) {
      result_.error = LearnError::kRegionInvalid;
      result_.message =
          "The region reaches out of the image, and what is left of it was taken "
          "for the object up to the image's border.";
      result_.hint = "Give a region inside the image with background on every side.";
      return;
    }
    result_.error = error;
    result_.message = message_of(error);
    result_.hint = hint_of(error);
    if (error != LearnError::kSuccess) result_.hint = result_.object.quality.advice.front();
    if (error != LearnError::kSuccess && may_be_cut_off())
      result_.hint = "The region may cut the object off: draw it larger.";
    if (error == LearnError::kTouchesBorder && took_the_platform()) {
      result_.message = "What was clicked reaches the image's border.";
      result_.hint = "Click on the object itself, or move it fully into view.";
    }
  }

  LessonState& state_;
  Lesson& lesson_;
  const LearningConfig& config_;
  const SearchConfig& search_;
  LessonProgress progress_;
  LearnResult& result_;
  MapCutter cutter_;
  cv::Mat modelled_;  // the map that the result's object was made from
};

// Runs `steps` and converts LessonEnded to `result`.
template <class Steps>
void run_to_result(LearnResult& result, Steps&& steps) {
  result = LearnResult();
  const StepTimer timer(result.timings_ms, "total");
  try {
    steps();
  } catch (const LessonEnded& ended) {
    result.error = ended.error();
    result.message = ended.what();
    result.hint = ended.hint();
    result.has_model = false;
  }
}

}  // namespace

void run_lesson(LessonState& state, const LearningConfig& config, const SearchConfig& search,
                const StageObserver& observer) {
  run_to_result(state.result, [&] { LessonRun(state, config, search, observer).learn(); });
}

void run_edit(LessonState& state, const LessonEdit& edit, const LearningConfig& config,
              const SearchConfig& search, const StageObserver& observer) {
  const bool has_map = state.result.has_model;
  run_to_result(state.result, [&] {
    if (!has_map) throw LessonEnded(LearnError::kRegionInvalid, "There is no map to edit yet.");
    LessonRun(state, config, search, observer).edit(edit);
  });
}

}  // namespace mbncc::teaching
