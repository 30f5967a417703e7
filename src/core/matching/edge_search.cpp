#include "matching/edge_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <tuple>

#include "matching/response_maps.hpp"
#include "polar/kernels.hpp"

namespace mbncc {
namespace {

constexpr int kOrientations = ResponseMaps::kOrientations;
constexpr int kStep = ResponseMaps::kStep;
constexpr int kUnit = kernels::kMaxResponse;  // response 1 in the maps

constexpr std::size_t kPoints = 64;  // of the contour
constexpr double kSmallest = 20;     // [px] diameter at the coarse level
constexpr double kThinnest = 2;      // [px] mean width there
constexpr int kTopLevel = 4;
constexpr double kArcStep = 2;          // [px] that the rim moves per rotation step, ...
constexpr double kNarrowArcStep = 1.3;  // ... of objects that a step would bring beside
constexpr double kNarrow = 3.5;         // [px] mean width there below which they are narrow
constexpr double kMinResponse = 0.2;    // [-1..1] mean of a candidate

int orientation_of(float normal_x, float normal_y) {
  const double turns = std::atan2(normal_y, normal_x) / kPi;  // of half a turn
  const int bin = static_cast<int>(std::lround(turns * kOrientations));
  return ((bin % kOrientations) + kOrientations) % kOrientations;
}

class EdgeSearch {
 public:
  EdgeSearch(const EdgeBank& bank, const SceneLevel& scene, const cv::Rect& roi,
             const RotationSector& sector, const Places& places)
      : bank_(bank),
        sector_(sector),
        first_(roi.x / kStep * kStep, roi.y / kStep * kStep),
        size_((roi.br().x - first_.x + kStep - 1) / kStep,
              (roi.br().y - first_.y + kStep - 1) / kStep),
        maps_(scene.responses(bank.radius() + 1)) {
    const int whole =
        (size_.width + kernels::kPositions - 1) / kernels::kPositions * kernels::kPositions;
    wanted_ = places.of_positions(bank.level(), first_, kStep, size_);
    cv::copyMakeBorder(wanted_, wanted_, 0, 0, 0, whole - size_.width, cv::BORDER_CONSTANT, {0});
    for (auto& quarter : quarters_) {
      quarter.best.create(size_.height, whole, CV_16SC1);
      quarter.best.setTo(0);
      quarter.rotation.create(size_.height, whole, CV_16SC1);
    }
    for (const auto& rotation : bank.rotations()) {
      offsets_.emplace_back();
      for (const auto& point : rotation.points)
        offsets_.back().push_back(maps_->offset(point.orientation, point.x, point.y) -
                                  maps_->offset(0, 0, 0));
    }
  }

  EdgeCandidates run(int most) {
    for (int y = 0; y < size_.height; ++y)
      for (const auto& span : covering_spans(wanted_.ptr(y), wanted_.cols, kernels::kPositions))
        for (std::size_t k = 0; k < offsets_.size(); ++k)
          if (sector_.contains(bank_.rotations()[k].angle)) add_rotation(k, y, span);
    for (auto& quarter : quarters_) quarter.best.setTo(0, wanted_ == 0);
    std::vector<Peak> peaks;
    for (const auto& quarter : quarters_) add_peaks(quarter, peaks);
    keep_best(peaks, static_cast<std::size_t>(most));
    EdgeCandidates found;
    for (const auto& peak : peaks) found.poses.push_back(candidate(peak));
    if (bank_.round()) found.round_places = different_places(found.poses);
    return found;
  }

 private:
  /// The best of a quarter turn's rotations at each position: outlines often fit again after half a
  /// turn or a quarter, and only the surface tells which.
  struct Quarter {
    cv::Mat best, rotation;  // CV_16SC1: sum and index of the rotation; rows of whole groups
  };

  const std::int8_t* at(int x, int y) const { return maps_->data() + maps_->offset(0, x, y); }

  void add_rotation(std::size_t k, int y, const Span& span) {
    Quarter& quarter = quarters_[k * quarters_.size() / offsets_.size()];
    kernels::sum_responses_max(
        at(first_.x + kStep * span.begin, first_.y + kStep * y), offsets_[k].data(),
        static_cast<int>(offsets_[k].size()), static_cast<std::int16_t>(k),
        quarter.best.ptr<std::int16_t>(y) + span.begin,
        quarter.rotation.ptr<std::int16_t>(y) + span.begin, span.end - span.begin);
  }

  struct Peak {
    int sum, rotation, x, y;
  };

  /// Positions whose sums no neighbour exceeds.
  void add_peaks(const Quarter& quarter, std::vector<Peak>& peaks) const {
    const int least = std::max(1, static_cast<int>(kMinResponse * kUnit * offsets_.front().size()));
    const cv::Mat best = quarter.best.colRange(0, size_.width);
    cv::Mat highest;
    cv::dilate(best, highest, cv::Mat(), {-1, -1}, 1, cv::BORDER_CONSTANT | cv::BORDER_ISOLATED);
    for (int y = 0; y < size_.height; ++y) {
      const auto* row = best.ptr<std::int16_t>(y);
      const auto* around = highest.ptr<std::int16_t>(y);
      for (int x = 0; x < size_.width; ++x)
        if (row[x] >= least && row[x] == around[x])
          peaks.push_back({row[x], quarter.rotation.at<std::int16_t>(y, x), x, y});
    }
  }

  /// The best `most`, best first; in the order of rotations and places where equal.
  static void keep_best(std::vector<Peak>& peaks, std::size_t most) {
    const auto better = [](const Peak& a, const Peak& b) {
      return std::make_tuple(-a.sum, a.rotation, a.y, a.x) <
             std::make_tuple(-b.sum, b.rotation, b.y, b.x);
    };
    const auto end = peaks.begin() + static_cast<std::ptrdiff_t>(std::min(most, peaks.size()));
    std::nth_element(peaks.begin(), end, peaks.end(), better);
    peaks.erase(end, peaks.end());
    std::sort(peaks.begin(), peaks.end(), better);
  }

  Candidate candidate(const Peak& peak) const {
    const Pose2D pose{double(first_.x + kStep * peak.x), double(first_.y + kStep * peak.y),
                      wrap_angle(bank_.rotations()[peak.rotation].angle)};
    return {pose, bank_.level(), mean(peak.sum)};
  }

  static std::vector<Candidate> different_places(const std::vector<Candidate>& found) {
    constexpr std::size_t kEnough = 250;
    std::vector<Candidate> places;
    for (const auto& candidate : found) {
      if (places.size() == kEnough) break;
      const bool known = std::any_of(places.begin(), places.end(), [&](const Candidate& place) {
        return place.pose.x == candidate.pose.x && place.pose.y == candidate.pose.y;
      });
      if (!known) places.push_back(candidate);
    }
    return places;
  }

  double mean(int sum) const {
    return sum / (static_cast<double>(kUnit) * offsets_.front().size());
  }

  const EdgeBank& bank_;
  RotationSector sector_;
  cv::Point first_;  // [px] position of best_'s first value, even
  cv::Size size_;    // of the positions
  cv::Mat wanted_;   // CV_8UC1, the positions searched; rows of whole groups
  std::shared_ptr<const ResponseMaps> maps_;
  std::vector<std::vector<std::int32_t>> offsets_;  // per rotation
  std::array<Quarter, 4> quarters_;
};

/// Part of one rotation's points that another rotation has as well, up to the spread.
double common_part(const EdgeBank::Rotation& one, const EdgeBank::Rotation& other) {
  const auto alike = [](const EdgeBank::Point& a, const EdgeBank::Point& b) {
    const int turned = std::abs(a.orientation - b.orientation);
    return std::abs(a.x - b.x) <= 1 && std::abs(a.y - b.y) <= 1 &&
           std::min(turned, kOrientations - turned) <= 1;
  };
  const auto found =
      std::count_if(one.points.begin(), one.points.end(), [&](const EdgeBank::Point& point) {
        return std::any_of(other.points.begin(), other.points.end(),
                           [&](const EdgeBank::Point& match) { return alike(point, match); });
      });
  return static_cast<double>(found) / static_cast<double>(one.points.size());
}

/// True when the contour looks much the same at most of the rotations.
bool looks_round(const std::vector<EdgeBank::Rotation>& rotations) {
  constexpr double kAlike = 0.7;
  const auto alike =
      std::count_if(rotations.begin(), rotations.end(), [&](const EdgeBank::Rotation& rotation) {
        return common_part(rotation, rotations.front()) >= kAlike;
      });
  return 2 * static_cast<std::size_t>(alike) > rotations.size();
}

int coarse_level(double diameter, double width) {
  const double halvings = std::min(std::log2(diameter / kSmallest), std::log2(width / kThinnest));
  return std::clamp(static_cast<int>(std::floor(halvings)), 0, kTopLevel);
}

}  // namespace

EdgeBank::EdgeBank(const MapGeometry& map, cv::Point2d anchor) {
  const ContourTemplate whole(ContourTemplate::edge_of(map, 0), anchor, 0, 4000);
  double reach = 1;
  for (std::size_t i = 0; i < whole.size(); ++i)
    reach = std::max<double>(reach, std::hypot(whole.x[i], whole.y[i]));
  level_ = coarse_level(2 * reach, map.mean_width());
  const ContourTemplate contour(ContourTemplate::edge_of(map, level_), anchor, level_, kPoints);
  radius_ = static_cast<int>(std::ceil(reach / (1 << level_))) + 1;
  const double rim = 2 * kPi * reach / (1 << level_);
  const double step = map.mean_width() < kNarrow * (1 << level_) ? kNarrowArcStep : kArcStep;
  const int count = std::max(12, static_cast<int>(std::ceil(rim / step)));
  for (int k = 0; k < count; ++k) {
    Rotation rotation{2 * kPi * k / count, {}};
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const cv::Point2d at = rotate({contour.x[i], contour.y[i]}, rotation.angle);
      const cv::Point2d normal = rotate({contour.normal_x[i], contour.normal_y[i]}, rotation.angle);
      rotation.points.push_back(
          {cvRound(at.x), cvRound(at.y),
           orientation_of(static_cast<float>(normal.x), static_cast<float>(normal.y))});
    }
    rotations_.push_back(rotation);
  }
  round_ = looks_round(rotations_);
}

EdgeCandidates edge_search(const EdgeBank& bank, const SceneLevel& scene, const cv::Rect& roi,
                           int most, const RotationSector& sector, const Places& places) {
  const cv::Rect region = roi & cv::Rect({0, 0}, scene.size());
  if (region.empty()) return {};
  return EdgeSearch(bank, scene, region, sector, places).run(most);
}

}  // namespace mbncc
