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

/// A frame at the wrong one of two angles or on another object would turn or displace the grasp.
void doubt_view(const Match& match, Quality& quality) {
  // The draft of a reviewed lesson was doubted before the operator accepted it.
  const auto& known = quality.reasons;
  if (std::find(known.begin(), known.end(), "view_uncertain") != known.end()) return;
  std::string reasons;
  for (const auto& reason : match.reasons) reasons += (reasons.empty() ? "" : "; ") + reason;
  quality.verdict = std::max(quality.verdict, Verdict::kMarginal);
  quality.reasons.push_back("view_uncertain");
  quality.advice.push_back("With its other views the object could not be grasped in this image (" +
                           reasons + "). Check that it is the same object and the same side.");
}

}  // namespace

std::optional<Match> match_in_view(const ObjectModel& stored, const View& view,
                                   const cv::Mat& image, const SearchConfig& search) {
  auto searched = std::make_shared<ObjectModel>(stored);
  searched->enabled = true;
  SearchRequest request;
  request.min_score = kLeastScore;
  request.max_instances = kPlacesTried;

  const cv::Mat map = full_size_map(view);
  std::optional<Match> found;
  double best = kLeastAgreement;
  Matcher matcher(search);
  matcher.set_objects({searched});
  for (const auto& match : matcher.find(image, request).matches) {
    const double agreed = segmentation::agreement_at(*searched, match.pose, map);
    if (agreed < best) continue;
    best = agreed;
    found = match;
  }
  return found;
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
  const auto match = match_in_view(stored, view, image, search);
  if (!match)
    return Refusal(
        LearnError::kNotDistinct,
        "The stored object was not found in the new image, so the new view cannot "
        "share its frame.",
        "A further view shows the same side, slightly rotated or in different light. Teach "
        "another side under its own name, or use overwrite.");
  if (!(match->margin_angle >= search.min_margin_angle))
    return Refusal(LearnError::kNotDistinct,
                   "The stored object fits the new image at two angles, so the new view cannot "
                   "share its frame.",
                   "Show what distinguishes the angles, in light like that of the first lesson. If "
                   "nothing does, declare the symmetry.");
  view.reference = match->pose;
  stored.views.push_back(view);
  stored.quality = learned.quality;
  if (!match->graspable) doubt_view(*match, stored.quality);
  declare_symmetry(stored, stored.symmetry);
  return {};
}

std::optional<Refusal> try_view(ObjectModel& learned, const ObjectModel& stored,
                                const cv::Mat& image, const SearchConfig& search) {
  ObjectModel tried = stored;
  const auto refusal = add_view(tried, learned, image, search);
  Quality& quality = learned.quality;
  if (!refusal) {
    quality = tried.quality;
    return {};
  }
  quality.verdict = Verdict::kBad;
  quality.reasons.insert(quality.reasons.begin(), "view_refused");
  quality.advice.insert(quality.advice.begin(),
                        "It cannot be added. " + refusal->message + " " + refusal->hint);
  return refusal;
}

}  // namespace mbncc
