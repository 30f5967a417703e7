// SPDX-License-Identifier: BSD-3-Clause
// Maps of every shape, including thin and long ones that fill their crop or touch the border of an
// image: every valid library file must be searchable.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "support/sanitizers.hpp"
#include "support/searched_map.hpp"

namespace mbncc::test {
namespace {

constexpr int kLongest = 16384;  // [px]

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : otherwise;
}

struct Case {
  MapShape shape;
  cv::Size size;
  Border learned, seen;
  int margin;
};

std::ostream& operator<<(std::ostream& out, const Case& one) {
  return out << "shape " << static_cast<int>(one.shape) << ", map " << one.size << ", learned at "
             << static_cast<int>(one.learned) << ", seen at " << static_cast<int>(one.seen)
             << ", margin " << one.margin;
}

void check(const Case& one, const SearchConfig& config = {}) {
  SCOPED_TRACE(::testing::Message() << one);
  const int longer = std::max(one.size.width, one.size.height);
  const int room = std::min(one.size.area() % 40, (kLongest - longer) / 2 - one.margin);
  const auto model = object_of(map_of(one.shape, one.size, 3), one.learned, one.margin, room, 5);
  const cv::Mat image = image_of(model->views.front(), {97, 66}, one.seen, 7);
  EXPECT_NO_THROW(check_search(config, model, image));
}

TEST(MapShapes, LinesThatFillTheirCropAreFound) {
  for (const cv::Size size : {cv::Size(1, 100), cv::Size(300, 1), cv::Size(3, 300), cv::Size(1, 1),
                              cv::Size(2, 2), cv::Size(4, 90), cv::Size(130, 7)})
    for (int border = 0; border < kBorders; ++border)
      check({MapShape::kFull, size, static_cast<Border>(border), static_cast<Border>(border), 0});
}

TEST(MapShapes, TheLongestLinesAreFound) {
  for (const cv::Size size :
       {cv::Size(kLongest, 1), cv::Size(1, kLongest), cv::Size(kLongest, 3), cv::Size(5, 5000)})
    check({MapShape::kFull, size, Border::kNone, Border::kLeft, 0});
  check({MapShape::kDiagonal, {1500, 1500}, Border::kTop, Border::kNone, 0});
}

// The sides are spread evenly over the powers of two; the area is bounded to save time.
TEST(MapShapes, AnyShapeAtAnyBorderIsFound) {
  std::mt19937 random(11);
  const auto any = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  const auto side = [&] {
    return std::min(kLongest, static_cast<int>(std::exp2(any(1400) / 100.0)) + any(2));
  };
  for (int tries = number_from("MBNCC_SHAPES", kSanitized ? 12 : 40); tries > 0;) {
    const Case one{static_cast<MapShape>(any(kMapShapes)),
                   {side(), side()},
                   static_cast<Border>(any(kBorders)),
                   static_cast<Border>(any(kBorders)),
                   any(3) * any(7)};
    if (one.size.area() > 20000) continue;
    --tries;
    SearchConfig config;
    if (any(8) == 0) config.scale_range = 0.1;
    check(one, config);
  }
}

TEST(MapShapes, AnObjectThatCannotBePreparedIsSkippedWithAReason) {
  SearchConfig config;
  config.engine = "polar";
  const auto large = object_of(map_of(MapShape::kFull, {6000, 2}, 1), Border::kNone, 0, 0, 1);
  const auto small = object_of(map_of(MapShape::kDisc, {31, 25}, 1), Border::kNone, 6, 9, 1);
  small->name = "small";
  Matcher matcher(config);
  matcher.set_objects({large, small});
  EXPECT_EQ(matcher.objects().size(), 1u);
  ASSERT_EQ(matcher.unsearchable().count("object"), 1u);
  const cv::Mat image = image_of(small->views.front(), {97, 66}, Border::kNone, 7);
  const SearchResult result = matcher.find(image);
  EXPECT_EQ(result.searched, std::vector<std::string>{"small"});
  ASSERT_EQ(result.skipped.size(), 1u);
  EXPECT_EQ(result.skipped.front().rfind("object: cannot be searched for: it is too large", 0), 0u)
      << result.skipped.front();
  SearchRequest request;
  request.names = {"object"};
  EXPECT_EQ(matcher.find(image, request).skipped, result.skipped);
}

}  // namespace
}  // namespace mbncc::test
