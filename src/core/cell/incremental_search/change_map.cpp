// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/change_map.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "imaging/rectangles.hpp"
#include "numeric/order_statistics.hpp"

namespace mbncc {
namespace {

constexpr double kLeastDifference = 4;  // [grey levels] least threshold for a cell's mean
constexpr double kSureDifference = 16;  // [grey levels] largest threshold for a cell's mean
constexpr double kNoiseFactor = 8;      // threshold in median differences of cells
constexpr float kFollow = 0.05F;        // [grey levels] drift of the reference per image
constexpr float kDark = 8;              // [grey levels] regularises ratios of dark cells
constexpr double kLeastGain = 0.5;      // exposure changes by at most this factor or its inverse
constexpr int kStride = 37;             // stride of the cells used for gain and noise
// [s] a patch that keeps changing for longer is reported anyway
constexpr double kLongestChange = 1.5;
constexpr double kRestTime = 0.095;  // [s] a patch must be at rest for this long to be reported
constexpr int kJoined = 3;           // [cells] side of the dilation that joins nearby patches
constexpr int kLeastCells = 2;       // least changed cells of a reported patch
constexpr int kLeastMoving = 2;      // cells in motion from which a patch is still changing
// Changed part of the cells above which has_changed_globally() holds
constexpr double kGlobalChange = 0.35;

cv::Mat cell_means(const cv::Mat& image) {
  cv::Mat cells = image;
  for (int side = ChangeMap::kCell; side > 1; side /= 2) {
    const cv::Size half(cells.cols / 2, cells.rows / 2);
    cv::Mat next;
    cv::resize(cells(cv::Rect(0, 0, 2 * half.width, 2 * half.height)), next, half, 0, 0,
               cv::INTER_AREA);
    cells = next;
  }
  return cells;
}

/// Median ratio per channel of `cells` (8 bits) to `base` (float or 8 bits).
template <class Base>
cv::Scalar median_gain(const cv::Mat& cells, const cv::Mat& base) {
  const int channels = cells.channels(), count = static_cast<int>(cells.total());
  const auto* now = cells.ptr<uchar>();
  const auto* then = base.ptr<Base>();
  cv::Scalar gain;
  std::vector<float> ratios;
  for (int channel = 0; channel < channels; ++channel) {
    ratios.clear();
    for (int i = 0; i < count; i += kStride)
      ratios.push_back(static_cast<float>((now[i * channels + channel] + kDark) /
                                          (then[i * channels + channel] + kDark)));
    gain[channel] = numeric::median(ratios);
  }
  return gain;
}

/// False if the light went out or returned, or the lens is covered.
bool is_exposure(const cv::Scalar& gain, int channels) {
  return std::all_of(gain.val, gain.val + channels,
                     [](double one) { return one >= kLeastGain && one <= 1 / kLeastGain; });
}

/// The channels' gains repeated, so that a loop over all values needs no modulo.
struct TiledGain {
  static constexpr int kLength = 48;

  TiledGain(const cv::Scalar& gain, int channels) {
    for (int i = 0; i < kLength; ++i) factors[i] = static_cast<float>(gain[i % channels]);
  }

  float factors[kLength];
};

/// 255 where a value of `cells` differs by more than `threshold` from that of `base` times `gain`.
template <class Base>
cv::Mat differing(const cv::Mat& cells, const cv::Mat& base, const cv::Scalar& gain,
                  double threshold) {
  cv::Mat differs(cells.size(), cells.type());
  const int count = static_cast<int>(cells.total()) * cells.channels();
  const auto* now = cells.ptr<uchar>();
  const auto* then = base.ptr<Base>();
  auto* out = differs.ptr<uchar>();
  const TiledGain tiled(gain, cells.channels());
  const float limit = static_cast<float>(threshold), dark = kDark;
  for (int i = 0; i < count; i += TiledGain::kLength)
    for (int k = 0; k < std::min(TiledGain::kLength, count - i); ++k) {
      const float difference =
          static_cast<float>(now[i + k]) + dark - tiled.factors[k] * (then[i + k] + dark);
      out[i + k] = std::abs(difference) > limit ? 255 : 0;
    }
  return differs;
}

/// 255 per cell where any channel is 255.
cv::Mat any_channel(const cv::Mat& values) {
  if (values.channels() == 1) return values;
  cv::Mat planes[3], any;
  cv::split(values, planes);
  cv::bitwise_or(planes[0], planes[1], any);
  cv::bitwise_or(any, planes[2], any);
  return any;
}

template <class Base>
double threshold_of(const cv::Mat& cells, const cv::Mat& base, const cv::Scalar& gain) {
  const int channels = cells.channels(), count = static_cast<int>(cells.total()) * channels;
  const auto* now = cells.ptr<uchar>();
  const auto* then = base.ptr<Base>();
  std::vector<float> differences;
  for (int i = 0; i < count; i += kStride)
    differences.push_back(
        static_cast<float>(std::abs(now[i] + kDark - gain[i % channels] * (then[i] + kDark))));
  return std::clamp<double>(kNoiseFactor * numeric::median(differences), kLeastDifference,
                            kSureDifference);
}

cv::Rect in_pixels(const cv::Rect& cells) {
  constexpr int side = ChangeMap::kCell;
  return {cells.x * side, cells.y * side, cells.width * side, cells.height * side};
}

/// Lets the reference follow slow drift where nothing differs.
void follow(const cv::Mat& cells, const cv::Mat& differs, const cv::Scalar& gain,
            cv::Mat& records) {
  const int count = static_cast<int>(cells.total()) * cells.channels();
  const auto* now = cells.ptr<uchar>();
  const auto* fixed = differs.ptr<uchar>();
  auto* record = records.ptr<float>();
  const TiledGain tiled(gain, cells.channels());
  const float dark = kDark;
  for (int i = 0; i < count; i += TiledGain::kLength)
    for (int k = 0; k < std::min(TiledGain::kLength, count - i); ++k) {
      const float behind =
          static_cast<float>(now[i + k]) + dark - tiled.factors[k] * (record[i + k] + dark);
      const float step = std::min(kFollow, std::max(-kFollow, behind));
      record[i + k] += fixed[i + k] ? 0 : step;
    }
}

/// Connected patches of cells; patches that nearly touch are joined.
struct Patches {
  explicit Patches(const cv::Mat& cells) {
    cv::Mat joined, centroids;
    cv::dilate(cells, joined, cv::Mat::ones(kJoined, kJoined, CV_8UC1));
    count = cv::connectedComponentsWithStats(joined, labels, statistics, centroids);
  }

  cv::Rect box(int label) const { return imaging::box_of_component(statistics, label); }

  cv::Mat labels, statistics;
  int count;  // label 0 is not a patch
};

}  // namespace

void ChangeMap::update(double stamp, const cv::Mat& image) {
  if (image.empty() || (image.type() != CV_8UC3 && image.type() != CV_8UC1))
    throw std::invalid_argument("a change map needs non-empty CV_8UC3 or CV_8UC1 images");
  const cv::Mat cells = cell_means(image);
  settled_.clear();
  drop_outdated(stamp);
  if (cells.size() != references_.size() || cells.channels() != references_.channels()) {
    cells.convertTo(references_, CV_32F);
    changed_ = cv::Mat::zeros(cells.size(), CV_8UC1);
    changed_globally_ = false;
    rested_at_ = stamp;
    earlier_.clear();
  } else {
    compare(stamp, cells);
  }
  earlier_.push_back({stamp, cells});
}

void ChangeMap::drop_outdated(double stamp) {
  while (earlier_.size() > 1 && stamp - earlier_[1].stamp >= kRestTime) earlier_.pop_front();
}

bool ChangeMap::touches(const cv::Rect& region) const {
  constexpr int side = kCell;
  const cv::Point low(region.x / side, region.y / side);
  const cv::Point high((region.br().x + side - 1) / side, (region.br().y + side - 1) / side);
  const cv::Rect cells = cv::Rect(low, high) & cv::Rect({0, 0}, changed_.size());
  return !cells.empty() && cv::countNonZero(changed_(cells)) > 0;
}

void ChangeMap::compare(double stamp, const cv::Mat& cells) {
  gain_ = median_gain<float>(cells, references_);
  if (!is_exposure(gain_, cells.channels())) {
    gain_ = cv::Scalar::all(1);
    changed_.setTo(255);
    changed_globally_ = true;
    return settle(stamp, cells);
  }
  const cv::Mat differs =
      differing<float>(cells, references_, gain_, threshold_of<float>(cells, references_, gain_));
  follow(cells, differs, gain_, references_);
  changed_ = any_channel(differs);
  const int count = cv::countNonZero(changed_);
  changed_globally_ = count > kGlobalChange * static_cast<double>(changed_.total());
  if (count > 0)
    settle(stamp, cells);
  else
    rested_at_ = stamp;
}

void ChangeMap::settle(double stamp, const cv::Mat& cells) {
  const cv::Mat moving = moving_cells(cells);
  const Patches patches(changed_);
  const bool may_wait = stamp - rested_at_ < kLongestChange;
  cv::Mat at_rest = cv::Mat::zeros(cells.size(), CV_8UC1);
  bool any_moving = false;
  for (int label = 1; label < patches.count; ++label) {
    const cv::Rect box = patches.box(label);
    const cv::Mat patch = patches.labels(box) == label;
    if (may_wait && cv::countNonZero(patch & moving(box)) >= kLeastMoving) {
      any_moving = true;
      continue;
    }
    at_rest(box).setTo(255, patch);
    if (cv::countNonZero(patch & changed_(box)) >= kLeastCells) settled_.push_back(in_pixels(box));
  }
  if (!any_moving) rested_at_ = stamp;
  update_reference(cells, at_rest);
}

cv::Mat ChangeMap::moving_cells(const cv::Mat& cells) const {
  const cv::Mat& before = earlier_.front().cells;
  const cv::Scalar gain = median_gain<uchar>(cells, before);
  const double threshold = threshold_of<uchar>(cells, before, gain);
  return any_channel(differing<uchar>(cells, before, gain, threshold));
}

void ChangeMap::update_reference(const cv::Mat& cells, const cv::Mat& which) {
  cv::Mat updated;
  cells.convertTo(updated, CV_32F, 1, kDark);
  cv::divide(updated, gain_, updated);
  cv::subtract(updated, cv::Scalar::all(kDark), updated);
  updated.copyTo(references_, which);
}

}  // namespace mbncc
