#include "nodelets/live_matcher.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

// A textured plate learned in a picture of its own.
ObjectModel plate(const std::string& name, cv::Size picture_size) {
  cv::RNG random(7);
  cv::Mat picture(picture_size, CV_8UC3), map = cv::Mat::zeros(picture_size, CV_8UC1);
  random.fill(picture, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(picture, picture, {0, 0}, 3);
  cv::ellipse(map, {picture_size.width / 2, picture_size.height / 2}, {30, 20}, 0, 0, 360, 255, -1);
  ObjectModel model;
  model.name = name;
  model.label = name;
  model.views.push_back(
      crop_view(picture, map, {picture_size.width / 2.0, picture_size.height / 2.0, 0}));
  return model;
}

class LiveMatcherTest : public ::testing::Test {
 protected:
  void store(const ObjectModel& model) {
    ObjectLibrary(folder_.path()).save(model, ObjectLibrary::Existing::kReplace);
  }

  test::TemporaryFolder folder_;
  const cv::Mat picture_ = cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(90));
};

TEST_F(LiveMatcherTest, SkipsObjectsOfOtherPictureSizesWithASentence) {
  store(plate("here", {160, 120}));
  store(plate("elsewhere", {320, 240}));
  const LiveMatcher matcher({}, folder_.path());
  const auto found = matcher.find(picture_, {}).result;
  EXPECT_EQ(found.searched, std::vector<std::string>{"here"});
  ASSERT_EQ(found.skipped.size(), 1u);
  EXPECT_EQ(found.skipped.front(),
            "elsewhere: learned in pictures of 320 x 240, this one is 160 x 120");
}

TEST_F(LiveMatcherTest, SearchesNothingWhenNoObjectFits) {
  store(plate("elsewhere", {320, 240}));
  const LiveMatcher matcher({}, folder_.path());
  EXPECT_TRUE(matcher.find(picture_, {}).result.searched.empty());
}

TEST_F(LiveMatcherTest, SaysThatARequestedNameIsUnknown) {
  store(plate("here", {160, 120}));
  const LiveMatcher matcher({}, folder_.path());
  SearchRequest request;
  request.names = {"wrench"};
  const auto found = matcher.find(picture_, request).result;
  EXPECT_TRUE(found.searched.empty());
  ASSERT_EQ(found.skipped.size(), 1u);
  EXPECT_EQ(found.skipped.front().rfind("wrench", 0), 0u);
}

TEST_F(LiveMatcherTest, TakesOverChangesOfTheFolder) {
  LiveMatcher matcher({}, folder_.path());
  EXPECT_TRUE(matcher.library()->objects.empty());
  store(plate("here", {160, 120}));
  matcher.refresh(false);
  EXPECT_EQ(matcher.library()->objects.size(), 1u);
  EXPECT_EQ(matcher.find(picture_, {}).library, matcher.library());
}

TEST_F(LiveMatcherTest, EveryObjectHasItsTurnWhenTimeIsShort) {
  for (const char* name : {"a", "b", "c"}) store(plate(name, {160, 120}));
  SearchConfig config;
  config.time_budget = 1e-9;
  const LiveMatcher matcher(config, folder_.path());
  std::vector<std::string> order;
  for (int i = 0; i < 6; ++i) {
    const auto found = matcher.find(picture_, {}).result;
    ASSERT_EQ(found.searched.size(), 1u);
    EXPECT_EQ(found.skipped.size(), 2u);
    EXPECT_TRUE(found.budget_exceeded);
    order.push_back(found.searched[0]);
  }
  EXPECT_EQ(order, (std::vector<std::string>{"a", "b", "c", "a", "b", "c"}));
}

TEST_F(LiveMatcherTest, LeavesDisabledObjectsAlone) {
  ObjectModel model = plate("here", {160, 120});
  model.enabled = false;
  store(model);
  const LiveMatcher matcher({}, folder_.path());
  EXPECT_TRUE(matcher.find(picture_, {}).result.searched.empty());
}

}  // namespace
}  // namespace mbncc::nodelets
