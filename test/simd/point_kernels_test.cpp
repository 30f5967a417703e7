// SPDX-License-Identifier: BSD-3-Clause
#include "simd/point_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace mbncc::kernels {
namespace {

constexpr int kRows = 37;

/// Random points, partly outside a random image, with odd counts and row lengths.
class PointKernels : public ::testing::TestWithParam<std::tuple<int, int>> {
 protected:
  PointKernels() : pixels_(static_cast<std::size_t>(kRows * step())) {
    for (auto& pixel : pixels_) pixel = static_cast<std::uint8_t>(random_());
    for (auto* places : {&x_, &y_}) *places = random_floats(-30, 30);
    for (int i = 0; i < count(); ++i) {
      const float angle = random_float(-3, 3);
      normal_x_.push_back(std::cos(angle));
      normal_y_.push_back(std::sin(angle));
    }
  }

  int count() const { return std::get<0>(GetParam()); }
  int columns() const { return std::get<1>(GetParam()); }
  int step() const { return 3 * columns() + 1; }
  Image8 image() const { return {pixels_.data(), step(), columns(), kRows}; }
  Points points() const { return {x_.data(), y_.data(), count()}; }

  float random_float(float low, float high) {
    return std::uniform_real_distribution<float>(low, high)(random_);
  }
  std::vector<float> random_floats(float low, float high) {
    std::vector<float> values(static_cast<std::size_t>(count()));
    for (auto& value : values) value = random_float(low, high);
    return values;
  }
  Placement random_placement() {
    const float angle = random_float(-3, 3), scale = random_float(0.8f, 1.25f);
    return {scale * std::cos(angle), scale * std::sin(angle), random_float(0, 40),
            random_float(0, 40), scale};
  }

  std::mt19937 random_{11};
  std::vector<std::uint8_t> pixels_;
  std::vector<float> x_, y_, normal_x_, normal_y_;
};

TEST_P(PointKernels, ColoursEqualReference) {
  const Placement placement = random_placement();
  std::vector<std::vector<float>> results;
  for (const auto* table : {&point_reference(), &vectorised_points()}) {
    std::vector<float> planes(static_cast<std::size_t>(4 * count()));
    float* first = planes.data();
    const Colours colours{first, first + count(), first + 2 * count(), first + 3 * count()};
    table->sample_colours_at(image(), points(), placement, colours);
    results.push_back(planes);
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST_P(PointKernels, NormalsEqualReference) {
  const Placement placement = random_placement();
  for (const int reach : {0, 1, 2}) {
    std::vector<std::vector<float>> results;
    for (const auto* table : {&point_reference(), &vectorised_points()}) {
      std::vector<float> read(static_cast<std::size_t>(4 * count()));
      float* first = read.data();
      const NormalReadings readings{first, first + count(), first + 2 * count(),
                                    first + 3 * count()};
      table->read_along_normals_at(image(), points(), normal_x_.data(), normal_y_.data(), placement,
                                   reach, readings);
      results.push_back(read);
    }
    EXPECT_EQ(results[0], results[1]) << "reach " << reach;
  }
}

TEST_P(PointKernels, ResponsesAreTheSameAtEveryReach) {
  const Placement placement = random_placement();
  const auto readings_at = [&](int reach) {
    std::vector<float> near(static_cast<std::size_t>(2 * count())), far = near;
    const NormalReadings readings{near.data(), near.data() + count(),
                                  reach > 0 ? far.data() : nullptr,
                                  reach > 0 ? far.data() + count() : nullptr};
    vectorised_points().read_along_normals_at(image(), points(), normal_x_.data(), normal_y_.data(),
                                              placement, reach, readings);
    return near;
  };
  EXPECT_EQ(readings_at(0), readings_at(1));
  EXPECT_EQ(readings_at(0), readings_at(2));
}

TEST_P(PointKernels, AgreementsEqualReference) {
  const Placement placement = random_placement();
  std::vector<float> expected(static_cast<std::size_t>(count())), actual = expected;
  point_reference().edge_agreements_at(image(), points(), normal_x_.data(), normal_y_.data(),
                                       placement, expected.data());
  vectorised_points().edge_agreements_at(image(), points(), normal_x_.data(), normal_y_.data(),
                                         placement, actual.data());
  EXPECT_EQ(expected, actual);
}

// The same pixels of the image, read with points that lie as much nearer as the object is larger.
TEST(PointReadings, DoNotGrowWithTheObject) {
  constexpr int kCount = 16;
  const std::vector<std::int8_t> edges(2 * 40 * 40, 90);
  const Image8 image{reinterpret_cast<const std::uint8_t*>(edges.data()), 80, 40, 40};
  const std::vector<float> normal_x(kCount, 0.6f), normal_y(kCount, 0.8f), none(kCount, 0);
  const auto readings = [&](const PointTable& table, float scale) {
    const Points points{none.data(), none.data(), kCount};
    const Placement placement{scale * std::cos(0.7f), scale * std::sin(0.7f), 20, 20, scale};
    std::vector<float> read(static_cast<std::size_t>(3 * kCount));
    table.read_along_normals_at(image, points, normal_x.data(), normal_y.data(), placement, 0,
                                {read.data(), read.data() + kCount, nullptr, nullptr});
    table.edge_agreements_at(image, points, normal_x.data(), normal_y.data(), placement,
                             read.data() + 2 * kCount);
    return read;
  };
  for (const auto* table : {&point_reference(), &vectorised_points()}) {
    const auto learned = readings(*table, 1), larger = readings(*table, 1.1f);
    ASSERT_GT(std::abs(learned[0]), 0.1);
    for (std::size_t i = 0; i < learned.size(); ++i)
      EXPECT_NEAR(larger[i], learned[i], 1e-4 * std::abs(learned[i])) << i;
  }
}

TEST_P(PointKernels, ChromaEqualsReference) {
  std::vector<float> logarithms(256);
  for (std::size_t i = 0; i < logarithms.size(); ++i)
    logarithms[i] = std::log(static_cast<float>(i) + 12);
  const ChromaCells cells{logarithms.data(), 0.6f, 8};
  const auto blue = random_floats(0, 255), green = random_floats(0, 255),
             red = random_floats(0, 255);
  std::vector<std::int32_t> expected(static_cast<std::size_t>(count())), actual = expected;
  point_reference().chroma_cells_of(cells, blue.data(), green.data(), red.data(), count(),
                                    expected.data());
  vectorised_points().chroma_cells_of(cells, blue.data(), green.data(), red.data(), count(),
                                      actual.data());
  EXPECT_EQ(expected, actual);
}

INSTANTIATE_TEST_SUITE_P(OddSizes, PointKernels,
                         ::testing::Combine(::testing::Values(1, 7, 16, 63, 64, 65, 161),
                                            ::testing::Values(16, 41, 64)));

}  // namespace
}  // namespace mbncc::kernels
