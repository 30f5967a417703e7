// SPDX-License-Identifier: BSD-3-Clause
// Watching while the library and the request change.
#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "cell/watched_scene.hpp"
#include "mbncc/cell/video_search.hpp"

namespace mbncc {
namespace {

TEST_F(VideoSearchTest, ObjectsComeAndGoWithTheLibrary) {
  matcher_.set_objects({models_[1]});
  put(0, kLeft);
  put(1, kRight);
  EXPECT_EQ(show_many(3).matches.size(), 1u);
  matcher_.set_objects({models_[0], models_[1]});
  EXPECT_TRUE(is_at(of(show_many(2), 0), kLeft));
  matcher_.set_objects({models_[0]});
  const SearchResult result = show();
  EXPECT_EQ(of(result, 1), nullptr);
  EXPECT_NE(of(result, 0), nullptr);
}

TEST_F(VideoSearchTest, OneOfTwoThatLookAlikeIsNeverGraspable) {
  matcher_.set_objects({learned(drawing(0), "one"), learned(drawing(0), "other")});
  show_many(3);
  put(0, kLeft);
  bool found = false;
  for (int i = 0; i < 20; ++i)
    for (const auto& match : show().matches) {
      found = true;
      EXPECT_FALSE(match.graspable) << i;
    }
  EXPECT_TRUE(found);
}

TEST_F(VideoSearchTest, ALookAlikeWhoseReferencePointLiesOutsideTheRegionCompetes) {
  const auto with_reference_at = [&](const std::string& name, double right) {
    const auto model = std::make_shared<ObjectModel>(*learned(drawing(0), name));
    move_reference(*model, compose(model->views.front().reference, {right, 0, 0}));
    return model;
  };
  const auto one = learned(drawing(0), "one");
  const auto other = with_reference_at("other", 80);
  const auto far = with_reference_at("far", -250);  // no region about it meets that of the others
  put(0, kLeft);
  SearchRequest request;
  request.roi = cv::Rect(cvRound(kLeft.x) - 20, cvRound(kLeft.y) - 20, 41, 41);
  const auto is_graspable_with = [&](std::vector<std::shared_ptr<const ObjectModel>> objects) {
    matcher_.set_objects(std::move(objects));
    video_.reset();
    bool graspable = false;
    for (int i = 0; i < 20; ++i) {
      const cv::Mat image = scene_.render(placed_, frames_, {});
      const auto result = video_.find(matcher_, kFrameTime * frames_++, image, request);
      EXPECT_LE(result.matches.size(), 1u) << i;
      for (const auto& match : result.matches) graspable |= match.graspable;
    }
    return graspable;
  };
  EXPECT_TRUE(is_graspable_with({one}));
  EXPECT_FALSE(is_graspable_with({one, other}));
  request.roi -=
      cv::Point(cvRound(250 * std::cos(kLeft.theta)), cvRound(250 * std::sin(kLeft.theta)));
  EXPECT_TRUE(is_graspable_with({far}));
  EXPECT_FALSE(is_graspable_with({far, one}));
}

// Outside the region lies a perfect instance, within it one that is partly covered.
TEST_F(VideoSearchTest, ABetterInstanceOutsideTheRegionCountsInEveryImage) {
  matcher_.set_objects({models_[0]});
  put(0, kRight);
  put(0, kLeft);
  put(1, {kLeft.x + 25, kLeft.y - 30, 1});
  SearchRequest request;
  request.roi = cv::Rect(cvRound(kLeft.x) - 20, cvRound(kLeft.y) - 20, 41, 41);
  const cv::Mat image = scene_.render(placed_, 1, {});
  const SearchResult whole = matcher_.find(image, request);
  ASSERT_EQ(whole.matches.size(), 1u);
  for (int i = 0; i < 40; ++i) {
    const auto result = video_.find(matcher_, kFrameTime * i, image, request);
    ASSERT_EQ(result.matches.size(), 1u) << i;
    EXPECT_NEAR(result.matches[0].log_odds(), whole.matches[0].log_odds(), 0.1) << i;
  }
}

TEST_F(VideoSearchTest, InARegionAtMostTheGivenNumberIsReportedAndTheOthersCompete) {
  matcher_.set_objects({models_[0]});
  put(0, kLeft);
  put(0, kRight);
  put(0, {300, 60, 0.2});
  SearchRequest request;
  request.roi = cv::Rect(200, 0, 200, 300);  // without kLeft
  for (const int most : {2, 1}) {
    request.max_instances = most;
    SearchResult result;
    for (int i = 0; i < 15; ++i) {
      const cv::Mat image = scene_.render(placed_, frames_, {});
      result = video_.find(matcher_, kFrameTime * frames_++, image, request);
    }
    const auto whole = matcher_.find(scene_.render(placed_, frames_, {}), request);
    for (const auto& found : {result, whole}) {
      ASSERT_EQ(found.matches.size(), static_cast<std::size_t>(most));
      for (const auto& match : found.matches) {
        EXPECT_GT(match.pose.x, 200);
        EXPECT_EQ(match.graspable, most == 2);
      }
      EXPECT_EQ(found.limited, std::vector<std::string>{name(0)});
    }
  }
}

TEST_F(VideoSearchTest, ASymmetricObjectIsReportedAtAnEquivalentPoseInTheRegion) {
  const auto model = std::make_shared<ObjectModel>(*models_[0]);
  model->symmetry = 2;
  move_reference(*model, compose(model->views.front().reference, {40, 0, 0}));
  matcher_.set_objects({model});
  put(0, kLeft);
  SearchRequest request;
  for (const double side : {40., -40.}) {
    const cv::Point2d end = transform(kLeft, {side, 0});
    request.roi = cv::Rect(cvRound(end.x) - 15, cvRound(end.y) - 15, 31, 31);
    SearchResult result;
    for (int i = 0; i < 5; ++i)
      result =
          video_.find(matcher_, kFrameTime * frames_++, scene_.render(placed_, 1, {}), request);
    ASSERT_EQ(result.matches.size(), 1u) << side;
    EXPECT_TRUE(request.roi.contains(result.matches[0].pose.position()));
  }
}

TEST_F(VideoSearchTest, RequestsForAPartOfTheImageAreRefused) {
  SearchRequest request;
  request.part = cv::Rect(0, 0, 100, 100);
  EXPECT_THROW(video_.find(matcher_, 0, scene_.render({}, 1, {}), request), std::invalid_argument);
}

// Grey pixels only surround a grey object, which was taught beside something coloured.
TEST_F(VideoSearchTest, APartOfAColourImageIsNotTakenForAGreyImage) {
  const auto grey = [](const cv::Mat& image) {
    cv::Mat one, three;
    cv::cvtColor(image, one, cv::COLOR_BGR2GRAY);
    cv::cvtColor(one, three, cv::COLOR_GRAY2BGR);
    return three;
  };
  const auto model = std::make_shared<ObjectModel>(*models_[0]);
  View& view = model->views.front();
  view.template_image = grey(view.template_image);
  ASSERT_EQ(view.map.at<uchar>(0, 0), 0);
  view.template_image.at<cv::Vec3b>(0, 0) = {0, 0, 255};
  matcher_.set_objects({model});
  put(0, kLeft);
  for (int i = 0; i < 40; ++i) {
    cv::Mat image = grey(scene_.render(placed_, i, {}));
    cv::circle(image, {360, 260}, 10, cv::Scalar(0, 0, 200), cv::FILLED);
    const auto matches = video_.find(matcher_, kFrameTime * i, image).matches;
    ASSERT_EQ(matches.size(), 1u) << i;
    EXPECT_TRUE(matches[0].graspable) << i << ": " << matches[0].reasons.at(0);
  }
}

TEST_F(VideoSearchTest, AfterALookAlikeIsForgottenTheOtherIsGraspable) {
  const std::vector<std::shared_ptr<const ObjectModel>> both{learned(drawing(0), "one"),
                                                             learned(drawing(0), "other")};
  put(0, kLeft);
  for (int kept = 0; kept < 2; ++kept) {  // the object that was shown, and the other one
    matcher_.set_objects(both);
    video_.reset();
    ASSERT_FALSE(show_many(20).matches.at(0).graspable);
    matcher_.set_objects({both[kept]});
    const SearchResult result = show_many(10);
    ASSERT_EQ(result.matches.size(), 1u) << kept;
    EXPECT_EQ(result.matches[0].name, both[kept]->name);
    EXPECT_TRUE(result.matches[0].graspable) << kept;
    EXPECT_TRUE(is_at(&result.matches[0], kLeft));
  }
}

TEST_F(VideoSearchTest, AnObjectTooLargeForTheImageIsLeftOutWithAReason) {
  const auto large = learned({30, 280, 1.5}, "large");
  matcher_.set_objects({models_[0], large});
  put(0, kLeft);
  const cv::Rect strip(0, 60, kSize.width, 60);
  const auto search = [&](const SearchRequest& request) {
    SearchResult result;
    for (int i = 0; i < 5; ++i) {
      const cv::Mat image = scene_.render(placed_, frames_, {})(strip);
      result = video_.find(matcher_, kFrameTime * frames_++, image, request);
    }
    return result;
  };
  for (const auto& names : {std::vector<std::string>{}, {name(0), large->name}}) {
    SearchRequest request;
    request.names = names;
    const SearchResult result = search(request);
    ASSERT_EQ(result.skipped.size(), 1u);
    EXPECT_EQ(result.skipped[0].rfind("large: the image is less than", 0), 0u) << result.skipped[0];
    ASSERT_NE(of(result, 0), nullptr);
    EXPECT_TRUE(of(result, 0)->graspable) << "compared with all that can be searched for";
  }
}

TEST_F(VideoSearchTest, ImagesThatCannotBeSearchedAreRefused) {
  for (const cv::Size& size : {cv::Size(1, 1), cv::Size(300, 8), cv::Size(8, 300)})
    EXPECT_THROW(video_.find(matcher_, 0, cv::Mat::zeros(size, CV_8UC1)), std::invalid_argument)
        << size;
}

TEST_F(VideoSearchTest, WithoutSweepsTheWholeOfEveryImageIsSearched) {
  video_ = VideoSearch({0, 2.0});
  put(0, kLeft);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(show().matches.at(0).fresh);
}

TEST_F(VideoSearchTest, AnotherRequestRestartsTheSearch) {
  put(0, kLeft);
  put(1, kRight);
  show_many(2);
  SearchRequest request;
  request.names = {name(1)};
  const auto result = video_.find(matcher_, kFrameTime * frames_, image_, request);
  ASSERT_EQ(result.matches.size(), 1u);
  EXPECT_EQ(result.matches[0].name, name(1));
  EXPECT_EQ(result.searched, request.names);
}

TEST_F(VideoSearchTest, AResetForgetsAllInstances) {
  put(0, kLeft);
  show_many(40);
  ASSERT_FALSE(of(show(), 0)->fresh);
  video_.reset();
  const SearchResult result = show();
  ASSERT_TRUE(of(result, 0));
  EXPECT_TRUE(of(result, 0)->fresh);
  EXPECT_EQ(result.searched.size(), models_.size());
}

TEST_F(VideoSearchTest, UnknownNamesAreReportedAsSkipped) {
  SearchRequest request;
  request.names = {"nobody"};
  put(0, kLeft);
  show();
  const auto result = video_.find(matcher_, kFrameTime * frames_, image_, request);
  ASSERT_EQ(result.skipped.size(), 1u);
  EXPECT_NE(result.skipped[0].find("nobody"), std::string::npos);
}

}  // namespace
}  // namespace mbncc
