#include "mbncc/learning/resemblance.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

constexpr double kLeastAgreement = 0.5;  // IoU of a found outline and the new map
constexpr double kLeastScore = 0.05;     // of a view: agreement with the map decides, not the score
constexpr int kPlacesTried = 5;

double agreement(const Match& match, const cv::Mat& map) {
  cv::Mat found = cv::Mat::zeros(map.size(), CV_8UC1);
  const std::vector<cv::Point> corners(match.outline.begin(), match.outline.end());
  if (corners.empty()) return 0;
  cv::fillPoly(found, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return cv::countNonZero(found & map) / static_cast<double>(cv::countNonZero(found | map));
}

std::vector<Match> matches_of(std::vector<std::shared_ptr<const ObjectModel>> objects,
                              const cv::Mat& picture, const SearchRequest& request,
                              const SearchConfig& search) {
  Matcher matcher(search);
  matcher.set_objects(std::move(objects));
  return matcher.find(picture, request).matches;
}

std::vector<std::shared_ptr<const ObjectModel>> others(
    const std::string& name, const std::vector<std::shared_ptr<const ObjectModel>>& known) {
  std::vector<std::shared_ptr<const ObjectModel>> result;
  std::copy_if(known.begin(), known.end(), std::back_inserter(result),
               [&name](const auto& object) { return object->enabled && object->name != name; });
  return result;
}

void warn(Quality& quality) {
  quality.verdict = std::max(quality.verdict, Verdict::kMarginal);
  quality.reasons.emplace_back("resembles_known");
  quality.advice.push_back("It looks like '" + quality.confusable_with +
                           "': one may be taken for the other. Teach a side that differs, or add "
                           "this picture to '" +
                           quality.confusable_with + "'.");
}

}  // namespace

std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& picture, const SearchConfig& search) {
  auto searched = std::make_shared<ObjectModel>(stored);
  searched->enabled = true;
  SearchRequest request;
  request.min_score = kLeastScore;
  request.max_instances = kPlacesTried;

  const cv::Mat map = full_size_map(view);
  std::optional<Pose2D> reference;
  double best = kLeastAgreement;
  for (const auto& match : matches_of({searched}, picture, request, search)) {
    const double agreed = agreement(match, map);
    if (agreed < best) continue;
    best = agreed;
    reference = match.pose;
  }
  return reference;
}

void note_resemblance(ObjectModel& object, const cv::Mat& picture,
                      const std::vector<std::shared_ptr<const ObjectModel>>& known,
                      const SearchConfig& search) {
  const auto searched = others(object.name, known);
  if (searched.empty()) return;
  const View& view = object.views.back();
  const cv::Mat map = full_size_map(view);
  SearchRequest request;
  request.roi = cv::Rect(view.origin, view.map.size());
  Quality& quality = object.quality;
  for (const auto& match : matches_of(searched, picture, request, search)) {
    if (match.score <= quality.confusable_score || agreement(match, map) < kLeastAgreement)
      continue;
    quality.confusable_with = match.name;
    quality.confusable_score = match.score;
  }
  if (quality.confusable_score >= search.confirm_score) warn(quality);
}

}  // namespace mbncc
