// SPDX-License-Identifier: BSD-3-Clause
// Learns objects with any map and searches them anywhere in small images: every map that a library
// file can contain must be searchable.
#include <algorithm>

#include "fuzz/fuzzer.hpp"
#include "support/searched_map.hpp"

using namespace mbncc;

namespace {

constexpr int kSmallSide = 48;  // [px]

int side_from(fuzz::Pieces& pieces) {
  // Usually small, sometimes as long as the largest image.
  const int low = pieces.byte(), high = pieces.byte();
  return high < 200 ? 1 + low % kSmallSide : 1 + (low | (high - 200) << 8);
}

// A map drawn by the fuzzer, or one of the predefined shapes.
cv::Mat map_from(fuzz::Pieces& pieces) {
  const int kind = pieces.byte();
  const int width = side_from(pieces);
  cv::Size size(width, side_from(pieces));
  if (size.area() > 20000) size.height = std::max(1, 20000 / size.width);
  if (kind < 128)
    return test::map_of(static_cast<test::MapShape>(kind % test::kMapShapes), size, 1);
  cv::Mat map = cv::Mat::zeros(size, CV_8UC1);
  for (int i = 0; i < size.area() && !pieces.empty(); i += 8) {
    const int bits = pieces.byte();
    for (int k = i; k < std::min(i + 8, size.area()); ++k)
      if ((bits >> (k - i) & 1) != 0) map.at<uchar>(k / size.width, k % size.width) = 255;
  }
  if (cv::countNonZero(map) == 0) map.at<uchar>(0, 0) = 255;
  return map;
}

test::Border border_from(fuzz::Pieces& pieces) {
  return static_cast<test::Border>(pieces.byte() % test::kBorders);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Pieces pieces(data, size);
  SearchConfig config;
  const int settings = pieces.byte();
  config.scale_range = settings % 8 == 1 ? 0.1 : 0;
  const test::Border learned = border_from(pieces), seen = border_from(pieces);
  const int margin = pieces.byte() % 13, room = pieces.byte() % 40;
  const int width = 16 + pieces.byte() % 96;
  const cv::Size shown(width, 16 + pieces.byte() % 96);
  const cv::Mat map = map_from(pieces);
  // The paper's engine takes minutes for large maps, or refuses them.
  const bool small = std::max(map.cols, map.rows) <= kSmallSide;
  config.engine = settings % 16 == 2 && small ? "polar" : "fast";
  const auto model = test::object_of(map, learned, margin, room, 1);
  if (model->views.front().map.cols == 1) fuzz::planted_bug(size);
  test::check_search(config, model, test::image_of(model->views.front(), shown, seen, 1));
  return 0;
}
