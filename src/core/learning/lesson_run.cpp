#include "learning/lesson_run.hpp"

#include <algorithm>
#include <chrono>

#include "learning/lesson_checks.hpp"
#include "learning/lesson_region.hpp"
#include "learning/put_aside.hpp"
#include "learning/rectangles.hpp"
#include "learning/stage_pictures.hpp"
#include "learning/step_timer.hpp"
#include "mbncc/learning/change.hpp"
#include "mbncc/learning/quality.hpp"

namespace mbncc {
namespace {

constexpr double kRefines = 0.75;   // agreement of two views, above which both make the map
constexpr double kDoubted = 0.2;    // change outside its region that forbids a map to be GOOD
constexpr double kTouching = 0.04;  // part of the outline on the region's edge that asks for more

enum class Room { kStays, kMayGrow };  // the region that is cut in

bool refines(const NewPlace& place) {
  return place.agreement >= kRefines;
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
        result_(state.result) {}

  void learn() {
    check_lesson(lesson_);
    if (is_shown_by_change_alone()) {
      find_place();
    } else {
      state_.cut = acquire_map();
      look_for_put_aside();
    }
    finish(*state_.cut);
  }

  void edit(const LessonEdit& edit) {
    state_.marks = painted(state_.marks, edit, lesson_.before.size());
    if (edit.reference) lesson_.reference = edit.reference;
    check_lesson(lesson_);
    if (edit.region != cv::Rect()) {
      point_at(edit.region);
      state_.cut = acquire_map();
      look_for_put_aside();
    }
    finish(cut_again());
  }

 private:
  void finish(const Segmentation& segmentation) {
    make_model(segmentation.map);
    if (const auto& place = state_.new_place)
      result_.put_aside = PutAside{compose(place->motion, result_.object.views.front().reference),
                                   place->agreement, refines(*place)};
    judge(segmentation);
  }

  // What was put aside within the view shows the object once more: a second opinion on the map.
  void look_for_put_aside() {
    state_.new_place.reset();
    if (!state_.cut->cut_with) return;
    const StepTimer timer(result_.timings_ms, "put_aside");
    make_model(state_.cut->map);
    state_.new_place =
        find_put_aside(result_.object, state_.cut->map, task_, surveyed_, config_, search_);
    if (!state_.new_place || !refines(*state_.new_place)) return;
    state_.cut = state_.cut->cut_with(state_.new_place->preference);
  }

  bool is_shown_by_change_alone() const {
    return is_without_place(lesson_) && lesson_.map.empty() && lesson_.outline.empty();
  }

  // Where nobody says which change is meant, it is the one that most speaks for; unless another one
  // is confirmed by its lying elsewhere now, and this one is not.
  void find_place() {
    task_ = mark_region();
    state_.cut = segment_if_possible(Room::kMayGrow);
    if (state_.cut && !state_.cut->cut_with) return;
    if (state_.cut) look_for_put_aside();
    if (state_.new_place || reconsider_place()) return;
    if (!state_.cut) state_.cut = segment_widened();  // throws: tells why there is none
    doubt_parts(*state_.cut);
  }

  // One of a map's parts may be where the object was put: a change outside the other one.
  static void doubt_parts(Segmentation& cut) {
    if (!cut.evidence || large_parts(cut.map).empty()) return;
    cut.evidence->change_outside = std::max(cut.evidence->change_outside, kDoubted);
  }

  bool reconsider_place() {
    const SegmentationTask first = task_;
    const cv::Mat& tried = state_.cut ? state_.cut->map : task_.approximate;
    const StepTimer timer(result_.timings_ms, "put_aside");
    for (const cv::Rect& place : large_parts(tried))
      if (left_from(place, Room::kStays)) return true;
    for (const cv::Rect& place : places_elsewhere(surveyed_, tried))
      if (left_from(place, Room::kMayGrow)) return true;
    task_ = first;
    return false;
  }

  // Did the object leave from `place`, and lie elsewhere now? Then it is learned there.
  bool left_from(const cv::Rect& place, Room room) {
    task_.region = place;
    task_.changed = surveyed_;
    const std::optional<Segmentation> other = segment_if_possible(room);
    if (!other || !other->cut_with) return false;
    make_model(other->map);
    const auto found =
        find_put_aside(result_.object, other->map, task_, surveyed_, config_, search_);
    if (!found) return false;
    state_.changed = surveyed_;
    state_.new_place = found;
    state_.cut = refines(*found) ? other->cut_with(found->preference) : *other;
    return true;
  }

  std::optional<Segmentation> segment_if_possible(Room room) {
    try {
      return room == Room::kMayGrow ? segment_widened() : segment(task_);
    } catch (const LessonEnded& ended) {
      if (ended.error() == LearnError::kCancelled) throw;
      return std::nullopt;
    }
  }

  // From here on, the lesson is taught by this region.
  void point_at(const cv::Rect& region) {
    lesson_.region = region;
    lesson_.map = cv::Mat();
    lesson_.outline.clear();
    lesson_.click.reset();
    if (lesson_.after.empty() && config_.method == "change_cut")
      throw LessonEnded(LearnError::kNoImage, "The method change_cut needs a picture after.");
  }

  Segmentation cut_again() {
    if (state_.marks.empty()) return *state_.cut;
    const StepTimer timer(result_.timings_ms, "segment");
    progress_.report(Stage::kSegment, 0.2, "Cutting the object out again.");
    Segmentation segmentation =
        state_.cut->cut_again
            ? state_.cut->cut_again(state_.marks)
            : Segmentation{
                  overpainted(state_.cut->map, state_.marks), state_.cut->evidence, {}, {}};
    check_map(segmentation.map, {{0, 0}, segmentation.map.size()});
    progress_.report(Stage::kSegment, 0.8, "The object is cut out.",
                     [&] { return outlined(lesson_.before, segmentation.map); });
    return segmentation;
  }

  // A ready map is the teacher's word, and so is an outline unless a method is asked to refine it.
  Segmentation acquire_map() {
    if (!lesson_.map.empty()) return accept(lesson_.map > 127);
    if (!lesson_.outline.empty() && config_.method == "auto") return accept(outline_map(lesson_));
    task_ = mark_region();
    return segment_widened();
  }

  Segmentation segment_widened() {
    const Segmentation found = segment(task_);
    return widen(task_, found) ? segment(task_) : found;
  }

  // A region that nobody drew may have been found too small. False: there is nothing to widen.
  bool widen(SegmentationTask& task, const Segmentation& found) const {
    if (!lesson_.outline.empty() || !found.evidence) return false;
    if (found.evidence->region_touch <= kTouching) return false;
    const int margin = std::max(task.region.width, task.region.height) / 2;
    const cv::Rect wider = grown(task.region, margin) & usable_region(lesson_);
    if (wider == task.region) return false;
    task.region = wider;
    return true;
  }

  Segmentation accept(const cv::Mat& map) {
    check_map(map, {{0, 0}, map.size()});
    progress_.report(Stage::kRegion, 0.1, "Taking the map as it is.",
                     [&] { return outlined(lesson_.before, map); });
    return {map, std::nullopt, {}, {}};
  }

  SegmentationTask mark_region() {
    const StepTimer timer(result_.timings_ms, "region");
    const RegionOfLesson region = region_of(lesson_, config_);
    SegmentationTask task{lesson_.before, lesson_.after, region.room, region.approximate,
                          region.changed};
    surveyed_ = region.surveyed;
    if (!task.changed.empty()) state_.changed = task.changed;
    progress_.report(Stage::kRegion, 0.1, "Marking the approximate region.",
                     [&] { return tinted(task.before, task.approximate, task.region); });
    return task;
  }

  Segmentation segment(const SegmentationTask& task) {
    const StepTimer timer(result_.timings_ms, "segment");
    Segmentation segmentation =
        segmenter_of(config_.method, !task.after.empty())(task, config_, progress_);
    check_map(segmentation.map, task.region);
    progress_.report(Stage::kSegment, 0.8, "The object is cut out.",
                     [&] { return outlined(task.before, segmentation.map); });
    return segmentation;
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
    object.learned_at =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    object.views = {crop_view(lesson_.before, map, reference)};
  }

  void judge(const Segmentation& segmentation) {
    const StepTimer timer(result_.timings_ms, "quality");
    progress_.report(Stage::kQuality, 0.85, "Judging the lesson.");
    Quality& quality = result_.object.quality;
    quality = assess_quality(result_.object, lesson_.before, state_.changed, segmentation.evidence,
                             config_, search_);
    // A ready map is never refused for quality: the verdict warns, no more.
    if (!lesson_.map.empty() && quality.verdict == Verdict::kBad)
      quality.verdict = Verdict::kMarginal;
    result_.has_model = true;
    progress_.report(Stage::kQuality, 1,
                     std::string("Verdict: ") + to_string(quality.verdict) + ".",
                     [&] { return outlined(lesson_.before, segmentation.map); });
    conclude(error_of(quality));
  }

  void conclude(LearnError error) {
    result_.error = error;
    result_.message = message_of(error);
    result_.hint = hint_of(error);
    if (error != LearnError::kSuccess) result_.hint = result_.object.quality.advice.front();
  }

  LessonState& state_;
  Lesson& lesson_;
  const LearningConfig& config_;
  const SearchConfig& search_;
  LessonProgress progress_;
  LearnResult& result_;
  SegmentationTask task_;
  cv::Mat surveyed_;  // all changes, arrivals included
  cv::Mat modelled_;  // the map that the result's object was made from
};

// Runs `steps` and turns the end of a lesson into values.
template <class Steps>
void conclude(LearnResult& result, Steps&& steps) {
  result = LearnResult();
  const StepTimer timer(result.timings_ms, "total");
  try {
    steps();
  } catch (const LessonEnded& ended) {
    result.error = ended.error();
    result.message = ended.what();
    result.hint = hint_of(ended.error());
    result.has_model = false;
  }
}

}  // namespace

void run_lesson(LessonState& state, const LearningConfig& config, const SearchConfig& search,
                const StageObserver& observer) {
  conclude(state.result, [&] { LessonRun(state, config, search, observer).learn(); });
}

void run_edit(LessonState& state, const LessonEdit& edit, const LearningConfig& config,
              const SearchConfig& search, const StageObserver& observer) {
  const bool has_map = state.result.has_model;
  conclude(state.result, [&] {
    if (!has_map)
      throw LessonEnded(LearnError::kRegionInvalid, "There is no map to be edited yet.");
    LessonRun(state, config, search, observer).edit(edit);
  });
}

}  // namespace mbncc
