// SPDX-License-Identifier: BSD-3-Clause
#include "mbncc/cell/video_search.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "cell/incremental_search/frame_search.hpp"
#include "cell/watched_scene.hpp"

namespace mbncc {
namespace {

TEST_F(VideoSearchTest, FirstImageIsSearchedLikeAnyOther) {
  put(0, kLeft);
  put(1, kRight);
  const SearchResult result = show();
  const SearchResult plain = matcher_.find(image_);
  ASSERT_EQ(result.matches.size(), plain.matches.size());
  for (std::size_t i = 0; i < plain.matches.size(); ++i) {
    EXPECT_EQ(result.matches[i].name, plain.matches[i].name);
    EXPECT_EQ(result.matches[i].pose.x, plain.matches[i].pose.x);
    EXPECT_EQ(result.matches[i].graspable, plain.matches[i].graspable);
  }
}

TEST_F(VideoSearchTest, AStillSceneIsSearchedAFewTimesOnly) {
  put(0, kLeft);
  put(1, kRight);
  show_many(40);
  int fresh = 0;
  for (int i = 0; i < 30; ++i) {
    const SearchResult result = show();
    ASSERT_EQ(result.matches.size(), 2u);
    for (const auto& match : result.matches) {
      fresh += match.fresh;
      EXPECT_TRUE(match.graspable);
    }
    EXPECT_EQ(result.searched.size(), 3u);
  }
  EXPECT_LE(fresh, 4) << "each is searched for every half second";
}

TEST_F(VideoSearchTest, EveryObjectIsSweptWithinItsPeriod) {
  const VideoConfig config{2.0, 2.0};
  incremental_search::SearchMemory memory({}, matcher_.config());
  put(0, kLeft);
  put(1, kRight);
  for (; frames_ < 66; ++frames_) {
    const cv::Mat image = scene_.render(placed_, frames_);
    incremental_search::FrameSearch search(memory, config, matcher_, kFrameTime * frames_, image);
    frames_ == 0 ? search.search_whole_image() : search.search_changes();
  }
  for (int i : {0, 1, 2}) EXPECT_GT(memory.objects.at(name(i)).swept_at, 0.1) << i;
}

TEST_F(VideoSearchTest, MovingObjectIsFoundInEveryImage) {
  put(0, kLeft);
  put(1, kRight);
  show_many(5);
  for (int i = 0; i < 25; ++i) {
    placed_[0].pose.x += 5;
    placed_[0].pose.theta += 0.05;
    const SearchResult result = show();
    EXPECT_TRUE(is_at(of(result, 0), placed_[0].pose)) << i;
    EXPECT_TRUE(of(result, 0)->fresh);
    EXPECT_TRUE(is_at(of(result, 1), kRight)) << i;
  }
}

TEST_F(VideoSearchTest, AJumpedObjectIsReportedAtItsNewPlaceOnly) {
  put(0, kLeft);
  put(1, kRight);
  show_many(5);
  placed_[0].pose = {250, 80, 2.5};
  EXPECT_EQ(of(show(), 0), nullptr) << "neither here nor there";
  EXPECT_TRUE(is_at(of(show_many(4), 0), placed_[0].pose));
  const SearchResult result = show_many(10);
  EXPECT_TRUE(of(result, 0)->graspable);
  EXPECT_EQ(result.matches.size(), 2u);
}

TEST_F(VideoSearchTest, NewObjectIsGraspableOnlyAfterAllWereSearchedThere) {
  put(1, kRight);
  show_many(5);
  put(0, kLeft);
  bool found = false, graspable = false;
  for (int i = 0; i < 15; ++i) {
    const SearchResult result = show();
    const Match* match = of(result, 0);
    found |= is_at(match, kLeft);
    graspable |= match && match->graspable;
    EXPECT_FALSE(match && match->graspable && !result.skipped.empty());
  }
  EXPECT_TRUE(found);
  EXPECT_TRUE(graspable);
}

// Regions of a video are searched for reference points, which may lie off the object and the image.
TEST_F(VideoSearchTest, FindsAnObjectWhoseReferencePointLiesAnywhere) {
  for (const double right : {-160., -60., 60., 160.}) {
    const auto model = std::make_shared<ObjectModel>(*models_[0]);
    move_reference(*model, compose(model->views.front().reference, {right, 0, 0}));
    matcher_.set_objects({model, models_[1]});
    video_.reset();
    placed_.clear();
    put(1, kRight);
    show_many(5);
    put(0, kLeft);
    bool graspable = false;
    for (int i = 0; i < 15 && !graspable; ++i) {
      const Match* match = of(show(), 0);
      graspable = is_at(match, compose(kLeft, {right, 0, 0})) && match->graspable;
    }
    EXPECT_TRUE(graspable) << right;
  }
}

/// A bar of one colour with its reference point at one end.
class WatchedBar : public VideoSearchTest {
 protected:
  WatchedBar() {
    const cv::Rect bar(60, 100, 160, 24);
    cv::Mat map = cv::Mat::zeros(kSize, CV_8UC1);
    lesson_(bar) = cv::Scalar(50, 90, 160);
    map(bar) = 255;
    model_->name = "bar";
    model_->views = {crop_view(lesson_, map, {70, 112, 0})};
  }

  SearchResult show_bar() {
    cv::Mat noise(kSize, CV_8UC3);
    cv::randn(noise, cv::Scalar::all(10), cv::Scalar::all(2));
    return video_.find(matcher_, kFrameTime * frames_++, lesson_ + noise);
  }

  cv::Mat lesson_{kSize, CV_8UC3, cv::Scalar::all(150)};
  std::shared_ptr<ObjectModel> model_ = std::make_shared<ObjectModel>();
};

// At the other angle, the reference point lies at the bar's other end.
TEST_F(WatchedBar, AnAngleWithADistantReferencePointCompetesInEverySearch) {
  model_->symmetry = 1;
  matcher_.set_objects({model_});
  int reported = 0;
  for (int i = 0; i < 20; ++i)
    for (const auto& match : show_bar().matches) {
      ++reported;
      EXPECT_FALSE(match.graspable) << i;
      EXPECT_TRUE(match.ambiguous) << i;
    }
  EXPECT_GE(reported, 18);
}

TEST_F(WatchedBar, AnEquivalentAngleIsTheSameInstance) {
  model_->symmetry = 2;
  matcher_.set_objects({model_});
  int fresh = 0;
  for (int i = 0; i < 40; ++i) {
    const auto matches = show_bar().matches;
    ASSERT_EQ(matches.size(), 1u) << i;
    EXPECT_TRUE(matches[0].graspable || i < 3) << i;
    fresh += i >= 20 && matches[0].fresh;
  }
  EXPECT_LE(fresh, 2) << "each is searched for every half second";
}

TEST_F(VideoSearchTest, NothingIsReportedInTheDark) {
  put(0, kLeft);
  show_many(30);
  ASSERT_TRUE(of(show(), 0)->graspable);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(of(show({}, 0.01), 0), nullptr) << i;
  EXPECT_TRUE(is_at(of(show_many(6), 0), kLeft)) << "light again";
}

TEST_F(VideoSearchTest, ObjectTakenAwayIsGoneInTheSameImage) {
  put(0, kLeft);
  put(1, kRight);
  show_many(5);
  placed_.erase(placed_.begin());
  const SearchResult result = show();
  EXPECT_EQ(of(result, 0), nullptr);
  EXPECT_NE(of(result, 1), nullptr);
}

TEST_F(VideoSearchTest, HiddenObjectIsFoundAgain) {
  put(0, kLeft);
  put(1, kRight);
  show_many(5);
  const sim::Arm arm{{100, 90, -kPi / 2}};
  for (int i = 0; i < 5; ++i) show(arm);
  EXPECT_TRUE(is_at(of(show_many(4), 0), kLeft));
}

TEST_F(VideoSearchTest, FlickerCostsNothing) {
  put(0, kLeft);
  show_many(25);
  int fresh = 0;
  for (int i = 0; i < 20; ++i) {
    const SearchResult result = show({}, 1 + 0.03 * std::sin(2.1 * i));
    ASSERT_EQ(result.matches.size(), 1u);
    fresh += result.matches[0].fresh;
  }
  EXPECT_LE(fresh, 2) << "as without flicker";
}

TEST_F(VideoSearchTest, TheWholeImageIsSearchedAfterACameraMotion) {
  put(0, kLeft);
  put(1, kRight);
  show_many(5);
  const cv::Mat still = image_;
  cv::Mat pushed;
  cv::warpAffine(still, pushed, cv::Matx23d(1, 0, 13, 0, 1, 8), kSize, cv::INTER_LINEAR,
                 cv::BORDER_REPLICATE);
  for (int i = 0; i < 3; ++i) video_.find(matcher_, kFrameTime * frames_++, pushed);
  const auto result = video_.find(matcher_, kFrameTime * frames_++, pushed);
  EXPECT_TRUE(is_at(of(result, 0), {kLeft.x + 13, kLeft.y + 8, kLeft.theta}));
  EXPECT_TRUE(is_at(of(result, 1), {kRight.x + 13, kRight.y + 8, kRight.theta}));
  EXPECT_TRUE(of(result, 0)->fresh);
}

}  // namespace
}  // namespace mbncc
