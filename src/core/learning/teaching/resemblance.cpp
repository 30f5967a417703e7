// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/learning/resemblance.hpp"

#include <algorithm>

#include "learning/quality/lesson_search.hpp"
#include "learning/segmentation/map_measures.hpp"
#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

constexpr double kLeastAgreement = 0.5;    // least IoU of a found map and the new one
constexpr double kLeastExtentRatio = 0.8;  // least ratio of the excircles' radii

std::vector<Match> matches_of(std::vector<std::shared_ptr<const ObjectModel>> objects,
                              const cv::Mat& image, const SearchRequest& request,
                              const SearchConfig& search) {
  Matcher matcher(quality::without_time_budget(search));
  matcher.set_objects(std::move(objects));
  return matcher.find(image, request).matches;
}

// Maps with the required IoU cannot differ more in area, nor much more in extent; other objects
// need not be searched for.
bool may_agree(const cv::Mat& a, const cv::Mat& b) {
  const auto alike = [](double first, double second, double ratio) {
    return first >= ratio * second && second >= ratio * first;
  };
  return alike(cv::countNonZero(a), cv::countNonZero(b), kLeastAgreement) &&
         alike(excircle(a).radius, excircle(b).radius, kLeastExtentRatio);
}

std::vector<std::shared_ptr<const ObjectModel>> rivals_of(
    const ObjectModel& object, const std::vector<std::shared_ptr<const ObjectModel>>& known) {
  const cv::Mat& map = object.views.back().map;
  std::vector<std::shared_ptr<const ObjectModel>> rivals;
  for (const auto& other : known)
    if (other->enabled && other->name != object.name &&
        std::any_of(other->views.begin(), other->views.end(),
                    [&map](const View& view) { return may_agree(view.map, map); }))
      rivals.push_back(quality::with_central_reference(*other));
  return rivals;
}

void warn(Quality& quality) {
  quality.verdict = std::max(quality.verdict, Verdict::kMarginal);
  quality.reasons.emplace_back("resembles_known");
  quality.advice.push_back("It looks like '" + quality.confusable_with +
                           "': the two may be confused. Teach a side that differs, or add "
                           "this image to '" +
                           quality.confusable_with + "'.");
}

}  // namespace

void note_resemblance(ObjectModel& object, const cv::Mat& image,
                      const std::vector<std::shared_ptr<const ObjectModel>>& known,
                      const SearchConfig& search) {
  const auto rivals = rivals_of(object, known);
  if (rivals.empty()) return;
  const View& view = object.views.back();
  const cv::Mat map = full_size_map(view);
  SearchRequest request;
  request.part = cv::Rect(view.origin, view.map.size());
  Quality& quality = object.quality;
  for (const auto& match : matches_of(rivals, image, request, search)) {
    const auto rival = std::find_if(rivals.begin(), rivals.end(),
                                    [&](const auto& other) { return other->name == match.name; });
    if (match.score <= quality.confusable_score ||
        segmentation::agreement_at(**rival, match.pose, map) < kLeastAgreement)
      continue;
    quality.confusable_with = match.name;
    quality.confusable_score = match.score;
  }
  if (quality.confusable_score >= search.confirm_score) warn(quality);
}

}  // namespace mbncc
