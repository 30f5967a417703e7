#include "matching/edge_search.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <opencv2/core.hpp>
#include <utility>

#include "matching/response_maps.hpp"
#include "polar/clones.hpp"
#include "polar/kernels.hpp"

namespace mbncc {
namespace {

constexpr int kStep = ResponseMaps::kStep;
constexpr int kUnit = kernels::kMaxResponse;  // response 1 in the maps
constexpr int kBand = kernels::kResponseRows;

constexpr double kMinResponse = 0.2;  // [-1..1] mean of a candidate

/// `count` rounded up to whole groups.
int whole(int count, int group) {
  return (count + group - 1) / group * group;
}

/// A position and rotation found, packed so that peaks in order are the best first; where sums are
/// equal, in the order of rotations and places.
class Peak {
 public:
  Peak(int sum, int rotation, int x, int y)
      : packed_(std::uint64_t(kMost - sum) << 48 | std::uint64_t(rotation) << 32 |
                std::uint64_t(y) << 16 | std::uint64_t(x)) {}

  int sum() const { return kMost - static_cast<int>(packed_ >> 48); }
  int rotation() const { return static_cast<int>(packed_ >> 32 & kMost); }
  int y() const { return static_cast<int>(packed_ >> 16 & kMost); }
  int x() const { return static_cast<int>(packed_ & kMost); }

  bool operator<(const Peak& other) const { return packed_ < other.packed_; }

 private:
  static constexpr int kMost = 0xffff;

  std::uint64_t packed_;
};

/// 1 in `marked` where a value of `row` is at least `least` and no neighbour exceeds it, of
/// `count`. `columns` has room for two more.
MBNCC_CLONES
void mark_peaks(const std::int16_t* __restrict above, const std::int16_t* __restrict row,
                const std::int16_t* __restrict below, int count, std::int16_t least,
                std::int16_t* __restrict columns, std::uint8_t* __restrict marked) {
  for (int x = 0; x < count; ++x) {
    const std::int16_t vertical = above[x] > below[x] ? above[x] : below[x];
    columns[x + 1] = vertical > row[x] ? vertical : row[x];
  }
  for (int x = 0; x < count; ++x) {
    const std::int16_t beside = columns[x] > columns[x + 2] ? columns[x] : columns[x + 2];
    const std::int16_t around = beside > columns[x + 1] ? beside : columns[x + 1];
    marked[x] = row[x] >= (around > least ? around : least) ? 1 : 0;
  }
}

/// Sets those of `count` values to 0 that are not wanted.
MBNCC_CLONES
void keep_wanted(const std::uint8_t* __restrict wanted, int count, std::int16_t* __restrict row) {
  for (int x = 0; x < count; ++x) row[x] = wanted[x] != 0 ? row[x] : std::int16_t{0};
}

/// The best of a part of a turn's rotations at the positions of a few rows: outlines often fit
/// again at another rotation, along edges of busy ground at many, and only the surface tells which.
class Sector {
 public:
  /// Of `groups` positions per row.
  void set_width(int groups) {
    width_ = groups;
    best_.assign(static_cast<std::size_t>(kRows) * width_, 0);
    labels_.assign(best_.size(), 0);
    column_.assign(width_ + 2, 0);
    marked_.resize(width_);
  }

  void add_rotation(const EdgeBank::Rotation& rotation, std::size_t label,
                    const ResponseMaps& maps) {
    for (const auto& point : rotation.points)
      offsets_.push_back(maps.offset(point.orientation, point.x, point.y) - maps.offset(0, 0, 0));
    labels_of_rotations_.push_back(static_cast<std::int16_t>(label));
    terms_ = static_cast<int>(rotation.points.size());
  }

  /// Goes on to the next band: the last rows of this one stay, as its neighbours.
  void next_band() {
    std::copy(best_.end() - kKept * width_, best_.end(), best_.begin());
    std::copy(labels_.end() - kKept * width_, labels_.end(), labels_.begin());
    std::fill(best_.begin() + kKept * width_, best_.end(), std::int16_t{0});
  }

  /// Sums at a group of positions from `x` on in the rows of the band; `maps` points at the first.
  void sum_responses(const std::int8_t* maps, int stride, int x) {
    const int at = kKept * width_ + x;
    kernels::best_responses(maps, stride,
                            {offsets_.data(), terms_, labels_of_rotations_.data(),
                             static_cast<int>(labels_of_rotations_.size())},
                            &best_[at], &labels_[at], width_);
  }

  /// Forgets what does not belong to the search: row `row` of the band where `wanted` is 0.
  void keep(int row, const uchar* wanted) {
    keep_wanted(wanted, width_, &best_[(kKept + row) * width_]);
  }

  /// Adds positions of at least `least` that no neighbour exceeds, in the rows whose neighbours are
  /// known: from one above the band, whose first row is `y`, to its last but one.
  void add_peaks(std::int16_t least, int y, std::vector<Peak>& peaks) {
    for (int row = 1; row <= kBand; ++row) {
      const std::int16_t* best = &best_[row * width_];
      mark_peaks(best - width_, best, best + width_, width_, least, column_.data(), marked_.data());
      const std::uint8_t* const end = marked_.data() + width_;
      for (const std::uint8_t* at = marked_.data();
           (at = static_cast<const std::uint8_t*>(
                std::memchr(at, 1, static_cast<std::size_t>(end - at)))) != nullptr;
           ++at) {
        const auto x = static_cast<int>(at - marked_.data());
        const int i = row * width_ + x;
        peaks.emplace_back(best_[i], labels_[i], x, y - kKept + row);
      }
    }
  }

 private:
  static constexpr int kKept = 2;
  static constexpr int kRows = kKept + kBand;

  std::vector<std::int32_t> offsets_;              // of all points of the rotations
  std::vector<std::int16_t> labels_of_rotations_;  // their indices
  int terms_ = 0, width_ = 0;
  std::vector<std::int16_t> best_, labels_;  // kRows rows: largest sums, and whose they are
  std::vector<std::int16_t> column_;         // largest of three rows, with one more on each side
  std::vector<std::uint8_t> marked_;         // 1: peaks of a row
};

class EdgeSearch {
 public:
  EdgeSearch(const EdgeBank& bank, const SceneLevel& scene, const cv::Rect& roi,
             const RotationSector& sector, const Places& places)
      : bank_(bank),
        scale_(kUnit * static_cast<double>(bank.rotations().front().points.size())),
        first_(roi.x / kStep * kStep, roi.y / kStep * kStep),
        size_((roi.br().x - first_.x + kStep - 1) / kStep,
              (roi.br().y - first_.y + kStep - 1) / kStep),
        maps_(scene.responses(bank.radius() + 1)) {
    // Nothing is wanted of the last row: the rows above it are complete with their neighbours.
    cv::copyMakeBorder(places.of_positions(bank.level(), first_, kStep, size_), wanted_, 0,
                       whole(size_.height + 1, kBand) - size_.height, 0,
                       whole(size_.width, kernels::kPositions) - size_.width, cv::BORDER_CONSTANT,
                       {0});
    for (auto& part : sectors_) part.set_width(wanted_.cols);
    const auto& rotations = bank.rotations();
    for (std::size_t k = 0; k < rotations.size(); ++k)
      if (sector.contains(rotations[k].angle))
        sectors_[k * sectors_.size() / rotations.size()].add_rotation(rotations[k], k, *maps_);
  }

  EdgeCandidates run(std::size_t foremost, std::size_t most) {
    auto least = static_cast<std::int16_t>(std::max(1.0, kMinResponse * scale_));
    thread_local std::vector<Peak> peaks;
    peaks.clear();
    bool before = false;
    for (int y = 0; y < wanted_.rows; y += kBand) {
      const bool wanted = cv::countNonZero(wanted_.rowRange(y, y + kBand)) > 0;
      if (!std::exchange(before, wanted) && !wanted) continue;  // nothing, nor in what is kept
      sum_band(y);
      for (auto& part : sectors_) part.add_peaks(least, y, peaks);
      if (peaks.size() > 2 * most) least = keep_best(peaks, most);
    }
    keep_best(peaks, most);
    put_foremost_first(peaks, foremost);
    EdgeCandidates found;
    found.poses.reserve(peaks.size());
    for (const auto& peak : peaks) found.poses.push_back(candidate(peak));
    if (bank_.round()) found.round_places = different_places(found.poses, foremost);
    return found;
  }

 private:
  void sum_band(int y) {
    for (auto& part : sectors_) part.next_band();
    cv::Mat any;
    cv::reduce(wanted_.rowRange(y, y + kBand), any, 0, cv::REDUCE_MAX);
    for (const auto& span : covering_spans(any.ptr(), any.cols, kernels::kPositions))
      for (int x = span.begin; x < span.end; x += kernels::kPositions) {
        const std::int8_t* maps =
            maps_->data() + maps_->offset(0, first_.x + kStep * x, first_.y + kStep * y);
        for (auto& part : sectors_) part.sum_responses(maps, maps_->stride(), x);
      }
    for (int row = 0; row < kBand; ++row)
      for (auto& part : sectors_) part.keep(row, wanted_.ptr(y + row));
  }

  static auto end_of(std::vector<Peak>& peaks, std::size_t count) {
    return peaks.begin() + static_cast<std::ptrdiff_t>(std::min(count, peaks.size()));
  }

  /// Drops all but the best `most`. Returns the sum that no other needs to fall below.
  static std::int16_t keep_best(std::vector<Peak>& peaks, std::size_t most) {
    if (peaks.size() <= most) return 1;
    const auto last = end_of(peaks, most) - 1;
    std::nth_element(peaks.begin(), last, peaks.end());
    const auto least = static_cast<std::int16_t>(last->sum());
    peaks.erase(last + 1, peaks.end());
    return least;
  }

  /// In order, the best that nothing better lies beside in the same quarter turn, `foremost` of
  /// them if there are as many: so that no place has them all.
  void put_foremost_first(std::vector<Peak>& peaks, std::size_t foremost) const {
    constexpr std::size_t kPerPlace = 4;
    const auto looked_at = end_of(peaks, kPerPlace * foremost);
    std::nth_element(peaks.begin(), looked_at, peaks.end());
    std::sort(peaks.begin(), looked_at);
    cv::Mat quarters = cv::Mat::zeros(wanted_.rows + 2, wanted_.cols + 2, CV_8UC1);
    std::stable_partition(peaks.begin(), looked_at,
                          [&](const Peak& peak) { return is_foremost(peak, quarters); });
  }

  /// Nothing better, which was asked for before, lies beside in its quarter turn: `quarters` has
  /// the bits of those that do.
  bool is_foremost(const Peak& peak, cv::Mat& quarters) const {
    const auto quarter =
        static_cast<uchar>(1 << 4 * peak.rotation() / static_cast<int>(bank_.rotations().size()));
    const bool foremost = (quarters.at<uchar>(peak.y() + 1, peak.x() + 1) & quarter) == 0;
    for (int y = peak.y(); y <= peak.y() + 2; ++y)
      for (int x = peak.x(); x <= peak.x() + 2; ++x) quarters.at<uchar>(y, x) |= quarter;
    return foremost;
  }

  Candidate candidate(const Peak& peak) const {
    const Pose2D pose{double(first_.x + kStep * peak.x()), double(first_.y + kStep * peak.y()),
                      bank_.rotations()[peak.rotation()].angle};
    return {pose, bank_.level(), peak.sum() / scale_};
  }

  /// Of the first `most` poses.
  static std::vector<Candidate> different_places(const std::vector<Candidate>& found,
                                                 std::size_t most) {
    constexpr std::size_t kEnough = 250;
    std::vector<Candidate> places;
    for (std::size_t i = 0; i < std::min(most, found.size()) && places.size() < kEnough; ++i) {
      const Candidate& candidate = found[i];
      const bool known = std::any_of(places.begin(), places.end(), [&](const Candidate& place) {
        return place.pose.x == candidate.pose.x && place.pose.y == candidate.pose.y;
      });
      if (!known) places.push_back(candidate);
    }
    return places;
  }

  const EdgeBank& bank_;
  double scale_;     // sum of responses that are 1
  cv::Point first_;  // [px] first position, even
  cv::Size size_;    // of the positions
  cv::Mat wanted_;   // CV_8UC1, the positions searched; whole groups and bands
  std::shared_ptr<const ResponseMaps> maps_;
  std::array<Sector, 16> sectors_;
};

}  // namespace

EdgeCandidates edge_search(const EdgeBank& bank, const SceneLevel& scene, const cv::Rect& roi,
                           std::size_t foremost, std::size_t most, const RotationSector& sector,
                           const Places& places) {
  const cv::Rect region = roi & cv::Rect({0, 0}, scene.size());
  if (region.empty()) return {};
  return EdgeSearch(bank, scene, region, sector, places).run(foremost, most);
}

}  // namespace mbncc
