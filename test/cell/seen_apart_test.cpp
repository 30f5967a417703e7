// SPDX-License-Identifier: BSD-3-Clause
// A look-alike that is refused only because the true object is visible elsewhere stays refused when
// the two are searched one after the other.
#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <vector>

#include "mbncc/cell/video_search.hpp"
#include "mbncc/sim/scene.hpp"

namespace mbncc {
namespace {

const cv::Size kSize(400, 300);

class SeenApart : public testing::Test {
 protected:
  SeenApart() {
    sim::SceneConfig plain;
    plain.size = kSize;
    const sim::Scene lesson(plain);
    const sim::Placed placed{kPart, {200, 150, 0}};
    auto model = std::make_shared<ObjectModel>();
    model->name = "part";
    model->views = {crop_view(lesson.render({placed}, 1), lesson.true_map(placed), placed.pose)};
    matcher_.set_objects({model});
  }

  /// The spoiled look-alike and, if `with_part`, the part.
  cv::Mat image(bool with_part) const {
    sim::SceneObject smaller = kPart;
    smaller.diameter *= 0.95;
    std::vector<sim::Placed> objects{{smaller, kLookAlike}};
    if (with_part) objects.push_back({kPart, kTrue});
    cv::Mat image = scene_.render(objects, static_cast<unsigned>(number_));
    cv::circle(image, cv::Point(112, 112), 10, cv::Scalar(90, 90, 90), cv::FILLED);
    return image;
  }

  static bool is_graspable(const SearchResult& result) {
    for (const auto& match : result.matches)
      if (cv::norm(match.pose.position() - kLookAlike.position()) < 6) return match.graspable;
    return false;
  }

  /// Whether the look-alike is graspable in the video although it is not in this image.
  bool is_wrongly_graspable(const cv::Mat& image) {
    const bool graspable = is_graspable(video_.find(matcher_, number_++ / 30., image, request_));
    return graspable && !is_graspable(matcher_.find(image));
  }

  static inline const sim::SceneObject kPart{150, 50, 1.5};
  static inline const Pose2D kLookAlike{100, 100, 0.5}, kTrue{290, 200, -1};
  const sim::Scene scene_{[] {
    sim::SceneConfig config;
    config.size = kSize;
    config.seed = 50;
    return config;
  }()};
  Matcher matcher_;
  VideoSearch video_;
  SearchRequest request_;
  int number_ = 0;
};

TEST_F(SeenApart, WhenBothAreTouchedInTheSameImage) {
  int wrong = 0;
  for (int i = 0; i < 90; ++i) {
    cv::Mat shown = image(i >= 15);
    if (i >= 50)
      for (const auto& corner : {cv::Point(76, 78), cv::Point(264, 176)})
        cv::rectangle(shown, {corner, cv::Size(5, 5)}, cv::Scalar::all(i % 2 ? 60 : 200),
                      cv::FILLED);
    wrong += is_wrongly_graspable(shown) && i >= 50 ? 1 : 0;
  }
  EXPECT_LE(wrong, 1);
}

TEST_F(SeenApart, WhenThePartWasHiddenForATime) {
  int wrong = 0;
  for (int i = 0; i < 180; ++i) {
    cv::Mat shown = image(i >= 15);
    if (i >= 50 && i < 110)  // a hand
      cv::rectangle(shown, cv::Rect(250 + (i - 50) % 25, 160, 80, 80), cv::Scalar(60, 60, 90),
                    cv::FILLED);
    if (i >= 60 && i < 64)
      cv::rectangle(shown, cv::Rect(76, 78, 5, 5), cv::Scalar::all(i % 2 ? 60 : 200), cv::FILLED);
    wrong += is_wrongly_graspable(shown) && i >= 120 ? 1 : 0;
  }
  EXPECT_LE(wrong, 1);
}

TEST_F(SeenApart, WhenThePartComesAndGoesOutsideTheRegion) {
  request_.roi = cv::Rect(80, 80, 41, 41);
  int wrong = 0;
  for (int i = 0; i < 120; ++i) {
    const bool is_wrong = is_wrongly_graspable(image(i >= 15 && i < 80));
    wrong += is_wrong && i >= 20 ? 1 : 0;  // what has just come is searched for once it is at rest
  }
  EXPECT_LE(wrong, 1);
  EXPECT_TRUE(is_graspable(video_.find(matcher_, number_ / 30., image(false), request_)));
}

}  // namespace
}  // namespace mbncc
