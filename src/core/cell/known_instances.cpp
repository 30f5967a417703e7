#include "cell/known_instances.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <utility>

namespace mbncc {
namespace {

cv::Mat filled(const std::vector<cv::Point2f>& outline, const cv::Rect& box) {
  std::vector<cv::Point> corners;
  for (const auto& point : outline)
    corners.emplace_back(cvRound(point.x) - box.x, cvRound(point.y) - box.y);
  cv::Mat area = cv::Mat::zeros(box.size(), CV_8UC1);
  cv::fillPoly(area, std::vector<std::vector<cv::Point>>{corners}, cv::Scalar(255));
  return area;
}

double distance(const Match& a, const Match& b) {
  return cv::norm(a.pose.position() - b.pose.position());
}

}  // namespace

cv::Rect Known::box() const {
  return cv::boundingRect(match.outline);
}

bool Known::is_compared() const {
  return std::isfinite(margin_elsewhere);
}

Match Known::judged(const SearchConfig& config) const {
  Match result = match;
  result.margin_place = std::min(result.margin_place, margin_to_others);
  if (is_compared()) result.margin_place = std::min(result.margin_place, margin_elsewhere);
  const bool sure = result.margin_place >= config.min_margin_place;
  result.graspable = result.graspable && is_compared() && sure;
  result.ambiguous = result.ambiguous || (result.score >= config.confirm_score && !sure);
  return result;
}

double outline_overlap(const std::vector<cv::Point2f>& a, const std::vector<cv::Point2f>& b) {
  const cv::Rect box_a = cv::boundingRect(a), box_b = cv::boundingRect(b);
  if ((box_a & box_b).empty()) return 0;
  const cv::Rect both = box_a | box_b;
  const cv::Mat area_a = filled(a, both), area_b = filled(b, both);
  const int smaller = std::min(cv::countNonZero(area_a), cv::countNonZero(area_b));
  return smaller > 0 ? static_cast<double>(cv::countNonZero(area_a & area_b)) / smaller : 0;
}

bool is_continued(const Match& before, const Match& now, double reach) {
  return before.name == now.name && distance(before, now) <= reach;
}

const Known* predecessor(const std::vector<Known>& before, const Match& now, double reach) {
  const Known* nearest = nullptr;
  for (const auto& known : before) {
    if (!is_continued(known.match, now, reach)) continue;
    if (!nearest || distance(known.match, now) < distance(nearest->match, now)) nearest = &known;
  }
  return nearest;
}

bool KnownInstances::shows(const std::string& name) const {
  return std::any_of(known_.begin(), known_.end(),
                     [&](const Known& one) { return one.match.name == name; });
}

Known* KnownInstances::admit(Known found, double reach) {
  const Match& match = found.match;
  const auto covers = [&](const Known& one) {
    return outline_overlap(one.match.outline, match.outline) > max_overlap_;
  };
  const auto beats = [&](const Known& one) {
    return covers(one) && !is_continued(one.match, match, reach) && one.match.score >= match.score;
  };
  note_rival({match.name, match.log_odds, match.outline});
  if (std::any_of(known_.begin(), known_.end(), beats)) return nullptr;
  for (const auto& one : take(covers))
    if (one.match.name != match.name)
      found.margin_to_others =
          std::min(found.margin_to_others, match.log_odds - one.match.log_odds);
  known_.push_back(std::move(found));
  return &known_.back();
}

void KnownInstances::note_rivals(const std::vector<Rival>& rivals) {
  for (const auto& rival : rivals) note_rival(rival);
}

void KnownInstances::note_rival(const Rival& rival) {
  for (auto& known : known_)
    if (known.match.name != rival.name &&
        outline_overlap(known.match.outline, rival.outline) > max_overlap_)
      known.margin_to_others =
          std::min(known.margin_to_others, known.match.log_odds - rival.log_odds);
}

}  // namespace mbncc
