// SPDX-License-Identifier: BSD-3-Clause
#include "learning/teaching/put_aside.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "imaging/rectangles.hpp"
#include "learning/change/changed_places.hpp"
#include "learning/change/departures.hpp"
#include "learning/change/survey_size.hpp"
#include "learning/quality/lesson_search.hpp"
#include "learning/segmentation/map_measures.hpp"
#include "mbncc/learning/change_cut.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc::teaching {
namespace {

constexpr int kGap = 9;                 // [px] pieces nearer than this are joined
constexpr double kSmallestPart = 0.25;  // least area of a place, relative to the object's
constexpr double kLargestPart = 4;      // largest area with a shadow, relative to the object's
constexpr std::size_t kPlacesTried = 2;
constexpr double kOtherPart = 0.05;  // least area of another possible place per map area
constexpr std::size_t kOthersTried = 3;
constexpr int kPartMargin = 4;           // [px] margin around a part of a map
constexpr double kLeastAgreement = 0.5;  // least IoU of the moved map and the cut at the place
constexpr float kLeast = -4;             // least log-odds by the other view

struct Place {
  cv::Rect box;
  bool within = true;     // it does not reach the image's border
  double unlikeness = 0;  // absolute log-ratio of its area to the object's
};

// Patches about as large as the object, the most likely ones first.
std::vector<Place> places_of(const cv::Mat& patches, double area) {
  cv::Mat joined, labels, stats, centres;
  cv::morphologyEx(patches, joined, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {kGap, kGap}));
  const cv::Rect all = cv::boundingRect(joined);
  if (all.empty()) return {};
  const int count =
      cv::connectedComponentsWithStats(joined(all), labels, stats, centres, 8, CV_32S);
  const cv::Rect image({0, 0}, patches.size());
  const cv::Rect inner = imaging::grown(image, -1 - patches.cols / change::kSurveyWidth);
  std::vector<Place> places;
  for (int i = 1; i < count; ++i) {
    const double part = stats.at<int>(i, cv::CC_STAT_AREA) / area;
    if (part < kSmallestPart || part > kLargestPart) continue;
    const cv::Rect box = imaging::box_of_component(stats, i) + all.tl();
    const int margin = std::max(8, std::max(box.width, box.height) * 15 / 100);
    places.push_back(
        {imaging::grown(box, margin) & image, (box & inner) == box, std::abs(std::log(part))});
  }
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return a.unlikeness < b.unlikeness; });
  places.resize(std::min(places.size(), kPlacesTried));
  return places;
}

// Arrivals first, then other changes, because on a platform of the object's colours an arrival may
// be taken for a departure. Other changes that reach the border are probably a gripper.
std::vector<Place> places_to_try(const cv::Mat& changed, const SegmentationTask& task,
                                 double area) {
  const cv::Mat left = change::departures(task.before, task.after, changed) > 0;
  std::vector<Place> places = places_of(changed & ~left, area);
  for (const Place& uncertain : places_of(changed & left, area))
    if (uncertain.within) places.push_back(uncertain);
  return places;
}

class PutAsideSearch {
 public:
  PutAsideSearch(const ObjectModel& object, const cv::Mat& map, const SearchConfig& search)
      : map_(map), matcher_(quality::without_time_budget(search)) {
    const auto centred = quality::with_central_reference(object);
    centre_ = centred->views.front().reference;
    matcher_.set_objects({centred}, true);
  }

  std::optional<NewPlace> find(const cv::Mat& after, const cv::Rect& place, const ObjectCut& cut) {
    SearchRequest request;
    request.part = place;
    request.max_instances = 3;
    std::optional<NewPlace> best;
    for (const Match& match : matcher_.find(after, request).matches) {
      const Pose2D motion = compose(match.pose, inverse(centre_));
      cv::Mat moved;
      cv::warpAffine(map_, moved, matrix_of(motion), map_.size(), cv::INTER_NEAREST);
      const double agreed = segmentation::map_iou(moved, cut.map);
      if (agreed < (best ? best->agreement : kLeastAgreement)) continue;
      best = NewPlace{motion, agreed, seen_from_before(cut.preference(), matrix_of(motion))};
    }
    return best;
  }

 private:
  // Pixels that lie beyond the border of the other view say nothing.
  static cv::Mat seen_from_before(const cv::Mat& preference, const cv::Matx23d& motion) {
    cv::Mat warped;
    cv::warpAffine(preference, warped, motion, preference.size(),
                   cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_CONSTANT, cv::Scalar(0));
    return cv::max(warped, kLeast);
  }

  cv::Mat map_;
  Pose2D centre_;
  Matcher matcher_;
};

std::optional<NewPlace> find_after_cut(const cv::Rect& place, const SegmentationTask& task,
                                       const cv::Mat& changed, const LearningConfig& config,
                                       PutAsideSearch& put_aside) {
  const ObjectCut cut =
      change_cut(task.after, task.before, place, changed, config.iterations, config.max_shift);
  return cut.cut_with ? put_aside.find(task.after, place, cut) : std::nullopt;
}

// Patches of `changed` that do not touch the map and have at least `least_part` of its area, with
// nearby pieces joined; empty if there are none.
cv::Mat patches_elsewhere(const cv::Mat& changed, const cv::Mat& map, double least_part) {
  const double scale = change::survey_scale(changed.cols);
  const int gap = cvRound(kGap * scale / 2) * 2 + 1;
  const cv::Mat disc = cv::getStructuringElement(cv::MORPH_ELLIPSE, {gap, gap});
  cv::Mat patches, vacated, labels, stats, centres, elsewhere;
  cv::resize(changed, patches, {}, scale, scale, cv::INTER_NEAREST);
  cv::resize(map, vacated, patches.size(), 0, 0, cv::INTER_NEAREST);
  const double least = least_part * cv::countNonZero(vacated);
  cv::dilate(vacated, vacated, disc);
  cv::morphologyEx(patches | vacated, patches, cv::MORPH_CLOSE, disc);
  const int count = cv::connectedComponentsWithStats(patches, labels, stats, centres, 8, CV_32S);
  std::vector<bool> touching(count, false);
  std::vector<cv::Point> pixels;
  cv::findNonZero(vacated, pixels);
  for (const auto& pixel : pixels) touching[labels.at<int>(pixel)] = true;
  for (int i = 1; i < count; ++i)
    if (touching[i] || stats.at<int>(i, cv::CC_STAT_AREA) < least) patches.setTo(0, labels == i);
  if (cv::countNonZero(patches) == 0) return {};
  cv::resize(patches, elsewhere, changed.size(), 0, 0, cv::INTER_NEAREST);
  return elsewhere & changed;
}

}  // namespace

std::optional<NewPlace> find_put_aside(const ObjectModel& object, const cv::Mat& map,
                                       const SegmentationTask& task, const cv::Mat& changed,
                                       const LearningConfig& config, const SearchConfig& search) {
  const cv::Mat elsewhere = patches_elsewhere(changed, map, kSmallestPart);
  if (elsewhere.empty()) return std::nullopt;
  const std::vector<Place> places = places_to_try(elsewhere, task, cv::countNonZero(map));
  if (places.empty()) return std::nullopt;
  PutAsideSearch put_aside(object, map, search);
  for (const Place& place : places)
    if (auto found = find_after_cut(place.box, task, changed, config, put_aside)) return found;
  return std::nullopt;
}

std::vector<cv::Rect> places_elsewhere(const cv::Mat& changed, const cv::Mat& map) {
  const cv::Mat elsewhere = patches_elsewhere(changed, map, kOtherPart);
  if (elsewhere.empty()) return {};
  std::vector<cv::Rect> places = change::changed_places(cv::Mat_<float>(elsewhere), false);
  places.resize(std::min(places.size(), kOthersTried));
  return places;
}

std::vector<cv::Rect> large_parts(const cv::Mat& map) {
  cv::Mat labels, stats, centres;
  const int count = cv::connectedComponentsWithStats(map, labels, stats, centres, 8, CV_32S);
  int largest = 0;
  for (int i = 1; i < count; ++i) largest = std::max(largest, stats.at<int>(i, cv::CC_STAT_AREA));
  std::vector<cv::Rect> parts;
  for (int i = 1; i < count; ++i) {
    if (stats.at<int>(i, cv::CC_STAT_AREA) < kSmallestPart * largest) continue;
    parts.push_back(imaging::grown(imaging::box_of_component(stats, i), kPartMargin) &
                    cv::Rect({0, 0}, map.size()));
  }
  if (parts.size() < 2) return {};
  parts.resize(std::min(parts.size(), kOthersTried));
  return parts;
}

}  // namespace mbncc::teaching
