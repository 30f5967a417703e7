#include "matching/contour_motion.hpp"

#include <array>

#include "matching/padded_vectors.hpp"

namespace mbncc {

ContourMotion::ContourMotion(const ContourTemplate& contour)
    : padded_(contour.x.size()), rows_(kRows * padded_, 0.f) {
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const float x = contour.x[i], y = contour.y[i];
    const float nx = contour.normal_x[i], ny = contour.normal_y[i];
    const std::array<float, kRows> distance{nx, ny, ny * x - nx * y, nx * x + ny * y, 1.f};
    for (std::size_t k = 0; k < kRows; ++k) rows_[k * padded_ + i] = distance[k];
  }
}

MotionPull ContourMotion::pull(const ContourSample& sample) const {
  constexpr double kOutwards = 0.5;  // [px] deviation of what moves all edges alike
  const auto along_rows = [&](const std::vector<float>& values) {
    std::array<float, kRows> products;
    kernels::dots(rows_.data(), padded_, kRows, values.data(), static_cast<int>(padded_),
                  products.data());
    return products;
  };
  cv::Matx<double, kRows, kRows> information;
  std::vector<float> weighted(padded_);
  for (int j = 0; j < kRows; ++j) {
    for (std::size_t i = 0; i < padded_; ++i) weighted[i] = rows_[j * padded_ + i] * sample.pull[i];
    const auto row = along_rows(weighted);
    for (int k = 0; k < kRows; ++k) information(j, k) = row[k];
  }
  const auto moments = along_rows(sample.moment);
  constexpr int kLast = kMotionParts;
  const double spread = information(kLast, kLast) + 1 / (kOutwards * kOutwards);
  MotionPull pull;
  for (int j = 0; j < kMotionParts; ++j) {
    // The template has to be moved from where the edges are: against the moments.
    pull.vector[j] = -moments[j] + information(j, kLast) / spread * moments[kLast];
    for (int k = 0; k < kMotionParts; ++k)
      pull.information(j, k) =
          information(j, k) - information(j, kLast) * information(kLast, k) / spread;
  }
  return pull;
}

}  // namespace mbncc
