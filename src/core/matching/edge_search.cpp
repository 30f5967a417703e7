#include "matching/edge_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "matching/edge_picture.hpp"
#include "polar/kernels.hpp"

namespace mbncc {
namespace {

constexpr int kOrientations = 8;     // of a half turn
constexpr std::size_t kPoints = 64;  // of the contour
constexpr double kSmallest = 20;     // [px] diameter at the coarse level
constexpr double kThinnest = 2;      // [px] mean width there
constexpr int kTopLevel = 4;
constexpr double kArcStep = 1.5;       // [px] that the rim moves per rotation step
constexpr double kMinResponse = 0.05;  // [-1..1] mean of a candidate
constexpr int kUnit = 32;              // response 1 in the maps
constexpr int kUnseen = 14;            // taken beyond the border, so that objects may hang over it

int orientation_of(float normal_x, float normal_y) {
  const double turns = std::atan2(normal_y, normal_x) / kPi;  // of half a turn
  const int bin = static_cast<int>(std::lround(turns * kOrientations));
  return ((bin % kOrientations) + kOrientations) % kOrientations;
}

/// Response maps per orientation, spread to the neighbouring pixels, with room around them.
class ResponseMaps {
 public:
  ResponseMaps(const cv::Mat& edges, int margin) : margin_(margin) {
    for (int k = 0; k < kOrientations; ++k) {
      const double angle = 2 * kPi * k / kOrientations;
      const double scale = static_cast<double>(kUnit) / kEdgeScale;
      cv::Mat response, spread;
      cv::transform(edges, response, cv::Matx12d(std::cos(angle), std::sin(angle)) * scale);
      response.convertTo(response, CV_16S);
      cv::dilate(response, spread, cv::Mat());
      cv::copyMakeBorder(spread, maps_[k], margin, margin, margin, margin, cv::BORDER_CONSTANT,
                         cv::Scalar(kUnseen));
    }
  }

  int stride() const { return maps_[0].cols; }

  const std::int16_t* at(int orientation, int x, int y) const {
    return maps_[orientation].ptr<std::int16_t>(y + margin_) + x + margin_;
  }

 private:
  int margin_;
  std::array<cv::Mat, kOrientations> maps_;  // CV_16SC1
};

class EdgeSearch {
 public:
  EdgeSearch(const EdgeBank& bank, const cv::Mat& edges, const cv::Rect& roi)
      : bank_(bank),
        roi_(roi & cv::Rect({0, 0}, edges.size())),
        maps_(edges, bank.radius() + 1),
        best_(roi_.size(), CV_16SC1, cv::Scalar(0)),
        sums_(roi_.width) {}

  EdgeCandidates run(int most_places) {
    for (int y = 0; y < roi_.height; ++y)
      for (const auto& rotation : bank_.rotations()) add_rotation(rotation, y);
    EdgeCandidates found;
    for (const auto& place : best_places(most_places)) add_rotations_at(place, found);
    return found;
  }

 private:
  void add_rotation(const EdgeBank::Rotation& rotation, int y) {
    rows_.clear();
    for (const auto& point : rotation.points)
      rows_.push_back(maps_.at(point.orientation, roi_.x + point.x, roi_.y + y + point.y));
    kernels::sum_rows_max(rows_.data(), static_cast<int>(rows_.size()), sums_.data(),
                          best_.ptr<std::int16_t>(y), roi_.width);
  }

  std::vector<Candidate> best_places(int most) const {
    cv::Mat highest;
    cv::dilate(best_, highest, cv::Mat());
    std::vector<Candidate> places;
    for (int y = 0; y < best_.rows; ++y)
      for (int x = 0; x < best_.cols; ++x) {
        const int sum = best_.at<std::int16_t>(y, x);
        if (sum < highest.at<std::int16_t>(y, x) || mean(sum) < kMinResponse) continue;
        places.push_back({{double(x + roi_.x), double(y + roi_.y), 0}, bank_.level(), mean(sum)});
      }
    sort_by_value(places);
    if (places.size() > static_cast<std::size_t>(most)) places.resize(most);
    return places;
  }

  double mean(int sum) const {
    return sum / (static_cast<double>(kUnit) * bank_.rotations().front().points.size());
  }

  double response(const EdgeBank::Rotation& rotation, const Pose2D& place) const {
    int sum = 0;
    for (const auto& point : rotation.points)
      sum += *maps_.at(point.orientation, static_cast<int>(place.x) + point.x,
                       static_cast<int>(place.y) + point.y);
    return mean(sum);
  }

  void add_rotations_at(const Candidate& place, EdgeCandidates& found) const {
    constexpr std::size_t kMost = 3;
    const auto& rotations = bank_.rotations();
    const std::size_t count = rotations.size();
    std::vector<double> values;
    for (const auto& rotation : rotations) values.push_back(response(rotation, place.pose));
    std::vector<Candidate> peaks;
    for (std::size_t k = 0; k < count; ++k) {
      const double before = values[(k + count - 1) % count], after = values[(k + 1) % count];
      if (values[k] < before || values[k] <= after || values[k] < 0.8 * place.value) continue;
      peaks.push_back(place);
      peaks.back().pose.theta = wrap_angle(rotations[k].angle);
      peaks.back().value = values[k];
    }
    sort_by_value(peaks);
    if (peaks.size() > kMost) peaks.resize(kMost);
    found.poses.insert(found.poses.end(), peaks.begin(), peaks.end());
    const auto high = std::count_if(values.begin(), values.end(),
                                    [&](double value) { return value > 0.85 * place.value; });
    if (2 * static_cast<std::size_t>(high) > count) found.round_places.push_back(place);
  }

  const EdgeBank& bank_;
  cv::Rect roi_;
  ResponseMaps maps_;
  cv::Mat best_;  // CV_16SC1, roi's size: largest sum over the rotations
  std::vector<std::int16_t> sums_;
  std::vector<const std::int16_t*> rows_;
};

int coarse_level(double diameter, double width) {
  const double halvings = std::min(std::log2(diameter / kSmallest), std::log2(width / kThinnest));
  return std::clamp(static_cast<int>(std::floor(halvings)), 0, kTopLevel);
}

}  // namespace

EdgeBank::EdgeBank(const MapGeometry& map, cv::Point2d anchor) {
  const ContourTemplate whole(map, anchor, 0, 4000);
  double reach = 1;
  for (std::size_t i = 0; i < whole.size(); ++i)
    reach = std::max<double>(reach, std::hypot(whole.x[i], whole.y[i]));
  level_ = coarse_level(2 * reach, map.mean_width());
  const ContourTemplate contour(map, anchor, level_, kPoints);
  radius_ = static_cast<int>(std::ceil(reach / (1 << level_))) + 1;
  const double rim = 2 * kPi * reach / (1 << level_);
  const int count = std::max(12, static_cast<int>(std::ceil(rim / kArcStep)));
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
}

EdgeCandidates edge_search(const EdgeBank& bank, const cv::Mat& edges, const cv::Rect& roi,
                           int most_places) {
  if ((roi & cv::Rect({0, 0}, edges.size())).empty()) return {};
  return EdgeSearch(bank, edges, roi).run(most_places);
}

}  // namespace mbncc
