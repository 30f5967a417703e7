#include "mbncc/learning/add_view.hpp"

#include <memory>
#include <opencv2/imgproc.hpp>

#include "mbncc/matching/matcher.hpp"

namespace mbncc {
namespace {

constexpr double kLeastAgreement = 0.5;  // IoU of the found outline and the new map
constexpr double kLeastScore = 0.05;     // agreement with the map decides, not the score
constexpr int kPlacesTried = 5;

double agreement(const Match& match, const cv::Mat& map) {
  cv::Mat found = cv::Mat::zeros(map.size(), CV_8UC1);
  const std::vector<cv::Point> corners(match.outline.begin(), match.outline.end());
  if (corners.empty()) return 0;
  cv::fillPoly(found, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return cv::countNonZero(found & map) / static_cast<double>(cv::countNonZero(found | map));
}

}  // namespace

std::optional<Pose2D> shared_reference(const ObjectModel& stored, const View& view,
                                       const cv::Mat& picture, const SearchConfig& search) {
  auto searched = std::make_shared<ObjectModel>(stored);
  searched->enabled = true;
  searched->min_score.reset();
  Matcher matcher(search);
  matcher.set_objects({searched});
  SearchRequest request;
  request.min_score = kLeastScore;
  request.max_instances = kPlacesTried;

  const cv::Mat map = full_size_map(view);
  std::optional<Pose2D> reference;
  double best = kLeastAgreement;
  for (const auto& match : matcher.find(picture, request).matches) {
    const double agreed = agreement(match, map);
    if (agreed < best) continue;
    best = agreed;
    reference = match.pose;
  }
  return reference;
}

}  // namespace mbncc
