// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/contour_search.hpp"

#include <algorithm>
#include <cstdint>
#include <opencv2/core.hpp>
#include <utility>

#include "matching/proposal/response_peaks.hpp"
#include "matching/scene/response_maps.hpp"
#include "simd/kernels.hpp"

namespace mbncc::proposal {
namespace {

constexpr int kStep = scene::ResponseMaps::kStep;
constexpr int kUnit = kernels::kMaxResponse;  // response 1 in the maps
constexpr int kBand = PeakFinder::kBand;

constexpr double kMinResponse = 0.2;  // [-1..1] least mean response of a candidate

/// Positions of a row whose responses at all rotations fit into the L1 cache.
constexpr int kAtATime = 2 * kernels::kPositions;

constexpr std::size_t kSectors = 16;  // of the rotations, each of which has peaks of its own
constexpr int kParts = 4;             // parts of an outline; one of them may be covered

double share(OutlinePart part) {
  return part == OutlinePart::kThreeQuarters ? double(kParts - 1) / kParts : 1;
}

/// `count` rounded up to whole groups.
int whole(int count, int group) {
  return (count + group - 1) / group * group;
}

class ContourSearch {
 public:
  ContourSearch(const ContourBank& bank, const scene::SceneLevel& scene, const cv::Rect& roi,
                const SearchMask& places, OutlinePart part)
      : bank_(bank),
        part_(part),
        scale_(kUnit * share(part) * static_cast<double>(bank.rotations().front().points.size())),
        first_(roi.x / kStep * kStep, roi.y / kStep * kStep),
        size_((roi.br().x - first_.x + kStep - 1) / kStep,
              (roi.br().y - first_.y + kStep - 1) / kStep),
        maps_(scene.responses(bank.radius() + 1)) {
    // The additional last row has no positions, so that every row above it has both neighbours.
    cv::copyMakeBorder(places.of_positions(bank.level(), first_, kStep, size_), wanted_, 0,
                       whole(size_.height + 1, kBand) - size_.height, 0,
                       whole(size_.width, kernels::kPositions) - size_.width, cv::BORDER_CONSTANT,
                       {0});
    sectors_.assign(kSectors, {wanted_.cols, part == OutlinePart::kThreeQuarters ? kParts : 1});
    const auto& rotations = bank.rotations();
    for (std::size_t k = 0; k < rotations.size(); ++k)
      sectors_[k * sectors_.size() / rotations.size()].add_rotation(rotations[k], k, *maps_);
  }

  std::vector<templates::Candidate> run(std::size_t most) {
    auto least = static_cast<std::int16_t>(std::max(1.0, kMinResponse * scale_));
    std::vector<ResponsePeak> peaks;
    bool before = false;
    for (int y = 0; y < wanted_.rows; y += kBand) {
      const bool wanted = cv::countNonZero(wanted_.rowRange(y, y + kBand)) > 0;
      if (!std::exchange(before, wanted) && !wanted)
        continue;  // nor in the rows kept from the last band
      sum_band(y);
      for (auto& part : sectors_) part.add_peaks(least, y, peaks);
      if (peaks.size() > 2 * most) least = keep_best(peaks, most);
    }
    keep_best(peaks, most);
    if (part_ == OutlinePart::kWhole) put_foremost_first(peaks);
    std::vector<templates::Candidate> found;
    found.reserve(peaks.size());
    for (const auto& peak : peaks) found.push_back(candidate(peak));
    return found;
  }

 private:
  void sum_band(int y) {
    for (auto& part : sectors_) part.next_band();
    cv::Mat any;
    cv::reduce(wanted_.rowRange(y, y + kBand), any, 0, cv::REDUCE_MAX);
    for (int x = 0; x < any.cols; x += kAtATime) {
      const int count = std::min(kAtATime, any.cols - x);
      if (cv::countNonZero(any.colRange(x, x + count)) == 0) continue;
      const std::int8_t* maps =
          maps_->data() + maps_->offset(0, first_.x + kStep * x, first_.y + kStep * y);
      for (auto& part : sectors_) part.sum_responses(maps, maps_->stride(), x, count);
    }
    for (int row = 0; row < kBand; ++row)
      for (auto& part : sectors_) part.keep(row, wanted_.ptr(y + row));
  }

  /// Keeps the best `most` peaks. Returns the least sum that further peaks need.
  static std::int16_t keep_best(std::vector<ResponsePeak>& peaks, std::size_t most) {
    if (peaks.size() <= most) return 1;
    const auto end = put_best_first(peaks, most);
    const auto least = std::min_element(
        peaks.begin(), end,
        [](const ResponsePeak& a, const ResponsePeak& b) { return a.sum() < b.sum(); });
    const auto sum = static_cast<std::int16_t>(least->sum());
    peaks.erase(end, peaks.end());
    return sum;
  }

  /// Sorts the peaks, those without a better neighbour in the same quarter turn first, so that the
  /// first of them cover different places.
  void put_foremost_first(std::vector<ResponsePeak>& peaks) const {
    std::sort(peaks.begin(), peaks.end());
    cv::Mat quarters = cv::Mat::zeros(wanted_.rows + 2, wanted_.cols + 2, CV_8UC1);
    std::stable_partition(peaks.begin(), peaks.end(),
                          [&](const ResponsePeak& peak) { return is_foremost(peak, quarters); });
  }

  /// Whether no better peak is a neighbour in the same quarter turn. Peaks must be tested best
  /// first; `quarters` stores, per position, a bit for each quarter turn with a tested neighbour.
  bool is_foremost(const ResponsePeak& peak, cv::Mat& quarters) const {
    const auto quarter =
        static_cast<uchar>(1 << 4 * peak.rotation() / static_cast<int>(bank_.rotations().size()));
    const bool foremost = (quarters.at<uchar>(peak.y() + 1, peak.x() + 1) & quarter) == 0;
    for (int y = peak.y(); y <= peak.y() + 2; ++y)
      for (int x = peak.x(); x <= peak.x() + 2; ++x) quarters.at<uchar>(y, x) |= quarter;
    return foremost;
  }

  templates::Candidate candidate(const ResponsePeak& peak) const {
    const Pose2D pose{double(first_.x + kStep * peak.x()), double(first_.y + kStep * peak.y()),
                      bank_.rotations()[peak.rotation()].angle};
    return {pose, bank_.level(), peak.sum() / scale_};
  }

  const ContourBank& bank_;
  OutlinePart part_;
  double scale_;     // sum of the responses of a rotation if all are 1
  cv::Point first_;  // [px] first position, even
  cv::Size size_;    // of the positions
  cv::Mat wanted_;   // CV_8UC1, the positions to search, padded to whole groups and bands
  std::shared_ptr<const scene::ResponseMaps> maps_;
  std::vector<PeakFinder> sectors_;
};

}  // namespace

std::vector<templates::Candidate> contour_search(const ContourBank& bank,
                                                 const scene::SceneLevel& scene,
                                                 const cv::Rect& roi, std::size_t most,
                                                 const SearchMask& places, OutlinePart part) {
  const cv::Rect region = roi & cv::Rect({0, 0}, scene.size());
  if (region.empty()) return {};
  return ContourSearch(bank, scene, region, places, part).run(most);
}

}  // namespace mbncc::proposal
