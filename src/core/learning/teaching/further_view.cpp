// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/further_view.hpp"

#include <algorithm>
#include <memory>

#include "learning/segmentation/map_measures.hpp"
#include "mbncc/matching/matcher.hpp"
#include "mbncc/symmetry.hpp"

namespace mbncc {
namespace {

constexpr double kLeastAgreement = 0.5;  // least IoU of the found map and the new one
constexpr double kLeastScore = 0.05;  // least score of a match; the agreement with the map decides
constexpr int kPlacesTried = 5;

/// Whether the object lies as in the other view and in the same light, so that the view adds
/// nothing.
bool shows_the_same(const View& one, const View& other) {
  constexpr double kSameMap = 0.9;  // common part of the larger map
  constexpr double kNoise = 4;      // [grey levels] mean difference of two images of one scene
  const cv::Rect place(one.origin, one.map.size()), other_place(other.origin, other.map.size());
  const cv::Rect common = place & other_place;
  if (one.image_size != other.image_size || common.empty()) return false;
  const cv::Rect here = common - one.origin, there = common - other.origin;
  const cv::Mat both = one.map(here) & other.map(there);
  const int larger = std::max(cv::countNonZero(one.map), cv::countNonZero(other.map));
  if (cv::countNonZero(both) < kSameMap * larger) return false;
  cv::Mat difference;
  cv::absdiff(one.template_image(here), other.template_image(there), difference);
  const cv::Scalar mean = cv::mean(difference, both);
  return std::max({mean[0], mean[1], mean[2]}) < kNoise;
}

}  // namespace

std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& image, const SearchConfig& search) {
  auto searched = std::make_shared<ObjectModel>(stored);
  searched->enabled = true;
  SearchRequest request;
  request.min_score = kLeastScore;
  request.max_instances = kPlacesTried;

  const cv::Mat map = full_size_map(view);
  std::optional<Pose2D> reference;
  double best = kLeastAgreement;
  Matcher matcher(search);
  matcher.set_objects({searched});
  for (const auto& match : matcher.find(image, request).matches) {
    const double agreed = segmentation::agreement_at(*searched, match.pose, map);
    if (agreed < best) continue;
    best = agreed;
    reference = match.pose;
  }
  return reference;
}

std::optional<Refusal> add_view(ObjectModel& stored, const ObjectModel& learned,
                                const cv::Mat& image, const SearchConfig& search) {
  View view = learned.views.front();
  for (const auto& known : stored.views)
    if (shows_the_same(view, known))
      return Refusal(
          LearnError::kAlreadyKnown,
          "'" + stored.name + "' already has this view: the object lies as in that image.",
          "Rotate the object slightly or change the light; then teach the view again. Another side "
          "is taught under its own name.");
  const auto reference = shared_reference(stored, view, image, search);
  if (!reference)
    return Refusal(
        LearnError::kNotDistinct,
        "The stored object was not found in the new image, so the new view cannot "
        "share its frame.",
        "A further view shows the same side, slightly rotated or in different light. Teach "
        "another side under its own name, or use overwrite.");
  view.reference = *reference;
  stored.views.push_back(view);
  stored.quality = learned.quality;
  declare_symmetry(stored, stored.symmetry);
  return {};
}

std::optional<Refusal> note_refused_view(ObjectModel& learned, const ObjectModel& stored,
                                         const cv::Mat& image, const SearchConfig& search) {
  ObjectModel tried = stored;
  const auto refusal = add_view(tried, learned, image, search);
  if (!refusal) return {};
  Quality& quality = learned.quality;
  quality.verdict = Verdict::kBad;
  quality.reasons.insert(quality.reasons.begin(), "view_refused");
  quality.advice.insert(quality.advice.begin(),
                        "It cannot be added. " + refusal->message + " " + refusal->hint);
  return refusal;
}

}  // namespace mbncc
