#include "polar/point_kernels.hpp"

#include <algorithm>

#include "polar/clones.hpp"
#include "polar/kernels.hpp"

namespace mbncc::kernels {
namespace {

// Pixels are read as whole words, at any address.
using Word = std::uint32_t __attribute__((aligned(1), may_alias));
using HalfWord = std::uint16_t __attribute__((aligned(1), may_alias));

// Points go through the stages of a kernel in groups whose intermediate values stay in the cache:
// the arithmetic before and after the reading of pixels is what the compiler can vectorise.
constexpr int kGroup = 64;

MBNCC_CLONES
void sample_group(const Picture8& picture, const float* __restrict px, const float* __restrict py,
                  int count, const Placement& placement, float* __restrict blue,
                  float* __restrict green, float* __restrict red, float* __restrict inside) {
  const float cosine = placement.cosine, sine = placement.sine, x0 = placement.x, y0 = placement.y;
  const float right = static_cast<float>(picture.columns) - 1.01f;
  const float bottom = static_cast<float>(picture.rows) - 1.01f;
  const int step = picture.step;
  float fx[kGroup], fy[kGroup];
  std::int32_t at[kGroup];
  for (int i = 0; i < count; ++i) {
    const float x = cosine * px[i] - sine * py[i] + x0, y = sine * px[i] + cosine * py[i] + y0;
    const float above_x = x > 0 ? x : 0, above_y = y > 0 ? y : 0;
    const float held_x = above_x < right ? above_x : right;
    const float held_y = above_y < bottom ? above_y : bottom;
    const float in_x = held_x == x ? 1.f : 0.f, in_y = held_y == y ? 1.f : 0.f;
    const int column = static_cast<int>(held_x), row = static_cast<int>(held_y);
    inside[i] = in_x * in_y;
    fx[i] = held_x - static_cast<float>(column);
    fy[i] = held_y - static_cast<float>(row);
    at[i] = row * step + 3 * column;
  }
  std::uint32_t a[kGroup], b[kGroup], c[kGroup], d[kGroup];
  for (int i = 0; i < count; ++i) {
    const std::uint8_t* above = picture.data + at[i];
    const std::uint8_t* below = above + step;
    // The right neighbour is read one byte early, so that no byte beyond the picture is touched.
    a[i] = *reinterpret_cast<const Word*>(above);
    b[i] = *reinterpret_cast<const Word*>(above + 2);
    c[i] = *reinterpret_cast<const Word*>(below);
    d[i] = *reinterpret_cast<const Word*>(below + 2);
  }
  const auto mix = [&](int shift, float* __restrict channel) {
    for (int i = 0; i < count; ++i) {
      const auto left_above = static_cast<float>(static_cast<int>(a[i] >> shift & 255));
      const auto right_above = static_cast<float>(static_cast<int>(b[i] >> (shift + 8) & 255));
      const auto left_below = static_cast<float>(static_cast<int>(c[i] >> shift & 255));
      const auto right_below = static_cast<float>(static_cast<int>(d[i] >> (shift + 8) & 255));
      const float top = left_above + fx[i] * (right_above - left_above);
      const float low = left_below + fx[i] * (right_below - left_below);
      channel[i] = inside[i] * (top + fy[i] * (low - top));
    }
  };
  mix(0, blue);
  mix(8, green);
  mix(16, red);
}

void sample_colours_vectorised(const Picture8& picture, const Points& points,
                               const Placement& placement, const Colours& colours) {
  for (int k = 0; k < points.count; k += kGroup)
    sample_group(picture, points.x + k, points.y + k, std::min(kGroup, points.count - k), placement,
                 colours.blue + k, colours.green + k, colours.red + k, colours.inside + k);
}

/// Contour points on their way through read_along_normals().
struct NormalGroup {
  float x[kGroup], y[kGroup], normal_x[kGroup], normal_y[kGroup], double_x[kGroup],
      double_y[kGroup];
  float best[kGroup], weights[kGroup], moments[kGroup], strongest[kGroup];
};

MBNCC_CLONES
void place_normals(const float* __restrict px, const float* __restrict py,
                   const float* __restrict nx, const float* __restrict ny, int count,
                   const Placement& placement, NormalGroup& group) {
  const float cosine = placement.cosine, sine = placement.sine, x0 = placement.x, y0 = placement.y;
  for (int i = 0; i < count; ++i) {
    group.x[i] = cosine * px[i] - sine * py[i] + x0;
    group.y[i] = sine * px[i] + cosine * py[i] + y0;
    const float x = cosine * nx[i] - sine * ny[i], y = sine * nx[i] + cosine * ny[i];
    group.normal_x[i] = x;
    group.normal_y[i] = y;
    group.double_x[i] = (x * x - y * y) / 127.f;
    group.double_y[i] = 2.f * x * y / 127.f;
    group.best[i] = -2;
    group.weights[i] = group.moments[i] = group.strongest[i] = 0;
  }
}

/// `near`: the reading counts as best response.
MBNCC_CLONES
void read_step(const Picture8& picture, int count, float step, bool near, NormalGroup& group) {
  const float right = static_cast<float>(picture.columns) - 1.01f;
  const float bottom = static_cast<float>(picture.rows) - 1.01f;
  const int stride = picture.step;
  float offset[kGroup], inside[kGroup];
  std::int32_t at[kGroup];
  for (int i = 0; i < count; ++i) {
    const float x = group.x[i] + step * group.normal_x[i] + 0.5f;
    const float y = group.y[i] + step * group.normal_y[i] + 0.5f;
    const float above_x = x > 1 ? x : 1, above_y = y > 1 ? y : 1;
    const float held_x = above_x < right ? above_x : right;
    const float held_y = above_y < bottom ? above_y : bottom;
    const float in_x = held_x == x ? 1.f : 0.f, in_y = held_y == y ? 1.f : 0.f;
    const int column = static_cast<int>(held_x), row = static_cast<int>(held_y);
    inside[i] = in_x * in_y;
    offset[i] = (static_cast<float>(column) - group.x[i]) * group.normal_x[i] +
                (static_cast<float>(row) - group.y[i]) * group.normal_y[i];
    at[i] = row * stride + 2 * column;
  }
  std::int32_t edges[kGroup];
  for (int i = 0; i < count; ++i)
    edges[i] = *reinterpret_cast<const HalfWord*>(picture.data + at[i]);
  const float allowance = near ? 0.f : -4.f;
  for (int i = 0; i < count; ++i) {
    const auto edge_x = static_cast<float>(
        static_cast<std::int32_t>(static_cast<std::uint32_t>(edges[i]) << 24) >> 24);
    const auto edge_y = static_cast<float>(
        static_cast<std::int32_t>(static_cast<std::uint32_t>(edges[i]) << 16) >> 24);
    const float response = group.double_x[i] * edge_x + group.double_y[i] * edge_y;
    const float candidate = inside[i] > 0 ? response + allowance : -2.f;
    group.best[i] = group.best[i] > candidate ? group.best[i] : candidate;
    const float positive = inside[i] * (response > 0 ? response : 0.f);
    const float square = positive * positive;
    group.weights[i] += square;
    group.moments[i] += square * offset[i];
    group.strongest[i] = group.strongest[i] > positive ? group.strongest[i] : positive;
  }
}

MBNCC_CLONES
void report_normals(const NormalGroup& group, int count, float* __restrict response,
                    float* __restrict seen, float* __restrict pull, float* __restrict moment) {
  for (int i = 0; i < count; ++i) {
    seen[i] = group.best[i] > -2.f ? 1.f : 0.f;
    response[i] = group.best[i] > -2.f ? group.best[i] : 0.f;
    pull[i] = group.strongest[i];
    moment[i] = group.strongest[i] * group.moments[i] / (group.weights[i] + 1e-12f);
  }
}

void read_along_normals_vectorised(const Picture8& picture, const Points& points,
                                   const float* normal_x, const float* normal_y,
                                   const Placement& placement, int reach,
                                   const NormalReadings& readings) {
  NormalGroup group;
  for (int k = 0; k < points.count; k += kGroup) {
    const int count = std::min(kGroup, points.count - k);
    place_normals(points.x + k, points.y + k, normal_x + k, normal_y + k, count, placement, group);
    for (int step = -reach; step <= reach; ++step)
      read_step(picture, count, static_cast<float>(step), step >= -1 && step <= 1, group);
    report_normals(group, count, readings.response + k, readings.seen + k, readings.pull + k,
                   readings.moment + k);
  }
}

MBNCC_CLONES
void edge_agreements_group(const Picture8& picture, const float* __restrict px,
                           const float* __restrict py, const float* __restrict dx,
                           const float* __restrict dy, int count, const Placement& placement,
                           float* __restrict agreements) {
  const float cosine = placement.cosine, sine = placement.sine, x0 = placement.x, y0 = placement.y;
  const float double_cosine = cosine * cosine - sine * sine, double_sine = 2.f * cosine * sine;
  const auto right = static_cast<float>(picture.columns - 1);
  const auto bottom = static_cast<float>(picture.rows - 1);
  const int stride = picture.step;
  std::int32_t at[kGroup], edges[kGroup];
  for (int i = 0; i < count; ++i) {
    const float x = cosine * px[i] - sine * py[i] + x0 + 0.5f;
    const float y = sine * px[i] + cosine * py[i] + y0 + 0.5f;
    const float above_x = x > 0 ? x : 0, above_y = y > 0 ? y : 0;
    const int column = static_cast<int>(above_x < right ? above_x : right);
    const int row = static_cast<int>(above_y < bottom ? above_y : bottom);
    at[i] = row * stride + 2 * column;
  }
  for (int i = 0; i < count; ++i)
    edges[i] = *reinterpret_cast<const HalfWord*>(picture.data + at[i]);
  for (int i = 0; i < count; ++i) {
    const auto edge_x = static_cast<float>(
        static_cast<std::int32_t>(static_cast<std::uint32_t>(edges[i]) << 24) >> 24);
    const auto edge_y = static_cast<float>(
        static_cast<std::int32_t>(static_cast<std::uint32_t>(edges[i]) << 16) >> 24);
    const float turned_x = double_cosine * dx[i] - double_sine * dy[i];
    const float turned_y = double_sine * dx[i] + double_cosine * dy[i];
    agreements[i] = turned_x * edge_x + turned_y * edge_y;
  }
}

void edge_agreements_vectorised(const Picture8& picture, const Points& points,
                                const float* direction_x, const float* direction_y,
                                const Placement& placement, float* agreements) {
  for (int k = 0; k < points.count; k += kGroup)
    edge_agreements_group(picture, points.x + k, points.y + k, direction_x + k, direction_y + k,
                          std::min(kGroup, points.count - k), placement, agreements + k);
}

MBNCC_CLONES
void chroma_cells_vectorised(const ChromaCells& cells, const float* __restrict blue,
                             const float* __restrict green, const float* __restrict red, int count,
                             std::int32_t* __restrict found) {
  const float* __restrict logarithms = cells.logarithms;
  const float reach = cells.reach, scale = static_cast<float>(cells.side) / (2.f * cells.reach);
  const auto last = static_cast<float>(cells.side - 1);
  const int side = cells.side;
  for (int i = 0; i < count; ++i) {
    const float reference = logarithms[static_cast<int>(green[i] + 0.5f)];
    const float u = (logarithms[static_cast<int>(red[i] + 0.5f)] - reference + reach) * scale;
    const float v = (logarithms[static_cast<int>(blue[i] + 0.5f)] - reference + reach) * scale;
    found[i] = side * static_cast<int>(std::min(std::max(u, 0.f), last)) +
               static_cast<int>(std::min(std::max(v, 0.f), last));
  }
}

MBNCC_CLONES
void add_capped_squares_vectorised(const float* __restrict model, const float* __restrict sample,
                                   const float* __restrict inside, const Gain& gain, float most,
                                   int count, float* __restrict squares) {
  const float factor = gain.factor, offset = gain.offset;
  for (int i = 0; i < count; ++i) {
    const float difference = sample[i] - factor * model[i] - offset;
    const float square = difference * difference;
    squares[i] += inside[i] * (square < most ? square : most);
  }
}

const PointTable& active_points() {
  static const PointTable& table =
      active().table == &reference() ? point_reference() : vectorised_points();
  return table;
}

}  // namespace

const PointTable& vectorised_points() {
  static const PointTable table{sample_colours_vectorised, read_along_normals_vectorised,
                                edge_agreements_vectorised, chroma_cells_vectorised,
                                add_capped_squares_vectorised};
  return table;
}

void sample_colours(const Picture8& picture, const Points& points, const Placement& placement,
                    const Colours& colours) {
  active_points().sample_colours_at(picture, points, placement, colours);
}

void read_along_normals(const Picture8& picture, const Points& points, const float* normal_x,
                        const float* normal_y, const Placement& placement, int reach,
                        const NormalReadings& readings) {
  active_points().read_along_normals_at(picture, points, normal_x, normal_y, placement, reach,
                                        readings);
}

void edge_agreements(const Picture8& picture, const Points& points, const float* direction_x,
                     const float* direction_y, const Placement& placement, float* agreements) {
  active_points().edge_agreements_at(picture, points, direction_x, direction_y, placement,
                                     agreements);
}

void chroma_cells(const ChromaCells& cells, const float* blue, const float* green, const float* red,
                  int count, std::int32_t* found) {
  active_points().chroma_cells_of(cells, blue, green, red, count, found);
}

void add_capped_squares(const float* model, const float* sample, const float* inside,
                        const Gain& gain, float most, int count, float* squares) {
  active_points().add_capped_squares_of(model, sample, inside, gain, most, count, squares);
}

}  // namespace mbncc::kernels
