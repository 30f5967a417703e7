// SPDX-License-Identifier: BSD-3-Clause
#include "matching/proposal/ncc_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "mbncc/matching/similarity.hpp"
#include "simd/kernels.hpp"

namespace mbncc::proposal {
namespace {

constexpr double kMinSimilarity = 0.3;   // [-1..1] of a candidate
constexpr double kRotationSlack = 0.12;  // further rotations at a place are kept within this

/// A rotated kernel as offsets into a padded image: pairs of adjacent pixels, and runs.
struct KernelOffsets {
  KernelOffsets(const RotatedKernel& kernel, int stride)
      : pixels(static_cast<double>(kernel.pixels.size())), norm(kernel.norm) {
    std::size_t next = 0;
    for (const auto& run : kernel.runs) {
      begins.push_back(run.y * stride + run.begin);
      ends.push_back(run.y * stride + run.end);
      for (int x = run.begin; x < run.end; x += 2) {
        offsets.push_back(run.y * stride + x);
        weights.push_back(kernel.weights[next++]);
        weights.push_back(x + 1 < run.end ? kernel.weights[next++] : std::int16_t{0});
      }
    }
  }

  int pairs() const { return static_cast<int>(offsets.size()); }
  int runs() const { return static_cast<int>(begins.size()); }

  std::vector<std::int32_t> offsets, begins, ends;
  std::vector<std::int16_t> weights;  // two per offset
  double pixels, norm;                // norm 0: not searched
};

class CoarseSearch {
 public:
  /// `image` has a margin of more than the bank's radius; `roi` lies in it.
  CoarseSearch(const TemplateBank& bank, const imaging::PaddedImage& image, const cv::Rect& roi)
      : bank_(bank), roi_(roi), image_(image) {
    for (const auto& kernel : *bank.kernels) offsets_.emplace_back(kernel, image_.stride());
    best_.create(roi_.size(), CV_32FC1);
    best_.setTo(-1);
  }

  std::vector<templates::Candidate> run(std::size_t most) {
    correlate(kMinSimilarity);
    return rotations_at(best_places(most));
  }

  /// The largest similarities over the rotations, exact above `threshold`.
  const cv::Mat& correlate(double threshold) {
    for (int y = 0; y < roi_.height; ++y)
      for (int x = 0; x < roi_.width; x += kBlock)
        correlate_block(x, y, std::min(kBlock, roi_.width - x), threshold);
    return best_;
  }

 private:
  static constexpr int kBlock = 2 * kernels::kPositions;  // positions of a row correlated at a time
  static constexpr int kPart = 16;  // positions of a block with a common decision

  /// Correlates all rotations at `count` positions of a row and updates `best_`. A rotation is
  /// normalised only where its numerator can reach the threshold or the best value so far, assuming
  /// that the image's variance under it is not much smaller than under the last normalised
  /// rotation.
  void correlate_block(int x, int y, int count, double threshold) {
    float* best = best_.ptr<float>(y) + x;
    const std::size_t start = image_.index(roi_.x + x, roi_.y + y);
    std::fill(gates_.begin(), gates_.end(), 0.f);
    for (const auto& kernel : offsets_) {
      if (kernel.norm <= 0) continue;
      kernels::correlate(&image_.pixels[start], kernel.offsets.data(), kernel.weights.data(),
                         kernel.pairs(), numerators_.data(), whole_groups(count));
      const float scale = 1 / static_cast<float>(kernel.norm);
      const kernels::Normalisation terms{scale, static_cast<float>(kernel.pixels),
                                         static_cast<float>(kNoiseVariance * kernel.pixels),
                                         static_cast<float>(threshold)};
      for (int part = 0; part < count; part += kPart) {
        const int positions = std::min(kPart, count - part);
        if (!kernels::any_above(&numerators_[part], scale, &gates_[part], positions)) continue;
        sum_block(kernel, start + part, positions);
        kernels::normalise(&numerators_[part], sums_.data(), squares_.data(), terms, best + part,
                           &gates_[part], positions);
      }
    }
  }

  static int whole_groups(int count) {
    return (count + kernels::kPositions - 1) / kernels::kPositions * kernels::kPositions;
  }

  void sum_block(const KernelOffsets& kernel, std::size_t start, int count) {
    kernels::sum_runs(&image_.sums[start], kernel.begins.data(), kernel.ends.data(), kernel.runs(),
                      sums_.data(), count);
    kernels::sum_runs(&image_.squares[start], kernel.begins.data(), kernel.ends.data(),
                      kernel.runs(), squares_.data(), count);
  }

  std::vector<templates::Candidate> best_places(std::size_t most) const {
    std::vector<templates::Candidate> places;
    cv::Mat highest;
    cv::dilate(best_, highest, cv::Mat());
    for (int y = 0; y < best_.rows; ++y)
      for (int x = 0; x < best_.cols; ++x)
        if (best_.at<float>(y, x) >= kMinSimilarity &&
            best_.at<float>(y, x) >= highest.at<float>(y, x))
          places.push_back({{static_cast<double>(x + roi_.x), static_cast<double>(y + roi_.y), 0},
                            bank_.level,
                            best_.at<float>(y, x)});
    templates::sort_by_value(places);
    if (places.size() > most) places.resize(most);
    return places;
  }

  std::vector<templates::Candidate> rotations_at(
      const std::vector<templates::Candidate>& places) const {
    std::vector<templates::Candidate> candidates;
    const std::size_t count = offsets_.size();
    std::vector<double> values(count);
    for (const auto& place : places) {
      const std::size_t at =
          image_.index(static_cast<int>(place.pose.x), static_cast<int>(place.pose.y));
      for (std::size_t k = 0; k < count; ++k) values[k] = value_at(offsets_[k], at);
      for (std::size_t k = 0; k < count; ++k) {
        const double before = values[(k + count - 1) % count], after = values[(k + 1) % count];
        if (values[k] < kMinSimilarity || values[k] < before || values[k] <= after ||
            values[k] < place.value - kRotationSlack)
          continue;
        candidates.push_back(place);
        candidates.back().pose.theta = wrap_angle((*bank_.kernels)[k].angle);
        candidates.back().value = values[k];
      }
    }
    return candidates;
  }

  double value_at(const KernelOffsets& kernel, std::size_t at) const {
    if (kernel.norm <= 0) return -1;
    int numerator = 0;
    double sum = 0, square = 0;
    for (int k = 0; k < kernel.pairs(); ++k) {
      const std::int16_t* from = &image_.pixels[at + kernel.offsets[k]];
      numerator += kernel.weights[2 * k] * from[0] + kernel.weights[2 * k + 1] * from[1];
    }
    for (int r = 0; r < kernel.runs(); ++r) {
      sum += image_.sums[at + kernel.ends[r]] - image_.sums[at + kernel.begins[r]];
      square += image_.squares[at + kernel.ends[r]] - image_.squares[at + kernel.begins[r]];
    }
    const double variance = square - sum * sum / kernel.pixels + kNoiseVariance * kernel.pixels;
    return numerator / (kernel.norm * std::sqrt(variance));
  }

  const TemplateBank& bank_;
  cv::Rect roi_;
  const imaging::PaddedImage& image_;
  std::vector<KernelOffsets> offsets_;
  cv::Mat best_;  // CV_32FC1, roi's size: largest similarity over the rotations
  std::array<std::int32_t, kBlock> numerators_{};
  std::array<std::int32_t, kPart> sums_{}, squares_{};
  std::array<float, kBlock> gates_{};
};

}  // namespace

std::vector<templates::Candidate> coarse_search(const TemplateBank& bank,
                                                const imaging::PaddedImage& image,
                                                const cv::Rect& roi, std::size_t most) {
  if (roi.empty()) return {};
  return CoarseSearch(bank, image, roi).run(most);
}

cv::Mat coarse_similarity(const TemplateBank& bank, const imaging::PaddedImage& image,
                          cv::Size size) {
  return CoarseSearch(bank, image, {{0, 0}, size}).correlate(0).clone();
}

}  // namespace mbncc::proposal
