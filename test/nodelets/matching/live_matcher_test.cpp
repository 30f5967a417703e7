// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/matching/live_matcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <future>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "mbncc/error.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

cv::Mat plate_image(cv::Size size) {
  cv::RNG random(7);
  cv::Mat image(size, CV_8UC3);
  random.fill(image, cv::RNG::UNIFORM, 0, 256);
  cv::GaussianBlur(image, image, {0, 0}, 3);
  return image;
}

// A textured plate learned in a separate image.
ObjectModel plate(const std::string& name, cv::Size image_size) {
  const cv::Mat image = plate_image(image_size);
  cv::Mat map = cv::Mat::zeros(image_size, CV_8UC1);
  cv::ellipse(map, {image_size.width / 2, image_size.height / 2}, {30, 20}, 0, 0, 360, 255, -1);
  ObjectModel model;
  model.name = name;
  model.label = name;
  model.views.push_back(
      crop_view(image, map, {image_size.width / 2.0, image_size.height / 2.0, 0}));
  return model;
}

class LiveMatcherTest : public ::testing::Test {
 protected:
  void store(const ObjectModel& model) {
    ObjectLibrary(folder_.path()).save(model, ObjectLibrary::Existing::kReplace);
  }

  test::TemporaryFolder folder_;
  const cv::Mat image_ = cv::Mat(120, 160, CV_8UC3, cv::Scalar::all(90));
};

TEST_F(LiveMatcherTest, SkipsObjectsOfOtherImageSizesWithAReason) {
  store(plate("here", {160, 120}));
  store(plate("elsewhere", {320, 240}));
  const LiveMatcher matcher({}, folder_.path());
  const auto found = matcher.find(image_, {}).result;
  EXPECT_EQ(found.searched, std::vector<std::string>{"here"});
  ASSERT_EQ(found.skipped.size(), 1u);
  EXPECT_EQ(found.skipped.front(),
            "elsewhere: learned in images of 320 x 240, this one is 160 x 120; teach it again at "
            "this size");
}

TEST_F(LiveMatcherTest, AChangedConfirmScoreAppliesToTheNextSearch) {
  store(plate("here", {160, 120}));
  LiveMatcher matcher({}, folder_.path());
  const auto complains = [&] {
    const auto found = matcher.find(plate_image({160, 120}), {}).result.matches;
    EXPECT_EQ(found.size(), 1u);
    return !found.empty() && std::any_of(found[0].reasons.begin(), found[0].reasons.end(),
                                         [](const std::string& reason) {
                                           return reason.find("confirm_score") != std::string::npos;
                                         });
  };
  EXPECT_FALSE(complains());
  SearchConfig config;
  config.confirm_score = 1;
  EXPECT_TRUE(matcher.configure(config));
  EXPECT_TRUE(complains());
  EXPECT_TRUE(matcher.configure({}));
  EXPECT_FALSE(complains());
  EXPECT_FALSE(matcher.configure({}));
}

TEST_F(LiveMatcherTest, SearchesNothingWhenNoObjectFits) {
  store(plate("elsewhere", {320, 240}));
  const LiveMatcher matcher({}, folder_.path());
  EXPECT_TRUE(matcher.find(image_, {}).result.searched.empty());
}

TEST_F(LiveMatcherTest, ReportsAnUnknownRequestedName) {
  store(plate("here", {160, 120}));
  const LiveMatcher matcher({}, folder_.path());
  SearchRequest request;
  request.names = {"wrench"};
  const auto found = matcher.find(image_, request).result;
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
  EXPECT_EQ(matcher.find(image_, {}).library, matcher.library());
}

TEST_F(LiveMatcherTest, EveryObjectHasItsTurnWhenTimeIsShort) {
  for (const char* name : {"a", "b", "c"}) store(plate(name, {160, 120}));
  SearchConfig config;
  config.time_budget = 1e-9;
  const LiveMatcher matcher(config, folder_.path());
  std::vector<std::string> order;
  for (int i = 0; i < 6; ++i) {
    const auto found = matcher.find(image_, {}).result;
    ASSERT_EQ(found.searched.size(), 1u);
    EXPECT_EQ(found.skipped.size(), 2u);
    EXPECT_TRUE(found.budget_exceeded);
    order.push_back(found.searched[0]);
  }
  EXPECT_EQ(order, (std::vector<std::string>{"a", "b", "c", "a", "b", "c"}));
}

TEST_F(LiveMatcherTest, SkipsDisabledObjects) {
  ObjectModel model = plate("here", {160, 120});
  model.enabled = false;
  store(model);
  const LiveMatcher matcher({}, folder_.path());
  EXPECT_TRUE(matcher.find(image_, {}).result.searched.empty());
}

// The paper's matching cannot use this map; the other objects are still searched, and the object
// can be deleted.
TEST_F(LiveMatcherTest, AnObjectThatCannotBePreparedDoesNotStopOthers) {
  store(plate("first", {160, 120}));
  store(plate("second", {160, 120}));
  SearchConfig config;
  config.engine = "polar";
  LiveMatcher matcher(config, folder_.path());
  EXPECT_EQ(matcher.fault(), "");
  ObjectModel beam = plate("beam", {6000, 120});
  beam.views.front().map = cv::Mat(2, 6000, CV_8UC1, cv::Scalar(255));
  beam.views.front().template_image = cv::Mat(2, 6000, CV_8UC3, cv::Scalar::all(80));
  beam.views.front().origin = {};
  store(beam);
  ObjectLibrary(folder_.path()).remove("first");
  matcher.refresh(false);
  EXPECT_EQ(matcher.fault().rfind("beam cannot be searched for: it is too large", 0), 0u)
      << matcher.fault();
  const auto names = [](const SearchResult& result) { return result.searched; };
  const auto found = matcher.find(image_, {}).result;
  EXPECT_EQ(names(found), std::vector<std::string>{"second"});
  ASSERT_EQ(found.skipped.size(), 1u);
  EXPECT_EQ(found.skipped.front().rfind("beam: cannot be searched for: ", 0), 0u);
  VideoSearch video(VideoConfig{});
  SearchRequest request;
  request.names = {"beam", "second"};
  const auto watched = matcher.watch(video, 1, image_, request).result;
  EXPECT_EQ(names(watched), std::vector<std::string>{"second"});
  EXPECT_EQ(watched.skipped, found.skipped);
  ObjectLibrary(folder_.path()).edit("second", [](ObjectModel& model) { model.enabled = false; });
  ObjectLibrary(folder_.path()).remove("beam");
  matcher.refresh(false);
  EXPECT_EQ(matcher.fault(), "");
  EXPECT_TRUE(names(matcher.find(image_, {}).result).empty());
}

TEST_F(LiveMatcherTest, ADeletedObjectIsNotFoundThoughSearchesOverlap) {
  store(plate("here", {160, 120}));
  LiveMatcher matcher({}, folder_.path());
  std::atomic<bool> ends{false};
  std::vector<std::future<void>> searches;
  for (int i = 0; i < 4; ++i)
    searches.push_back(std::async(std::launch::async, [&] {
      while (!ends) matcher.find(plate_image({160, 120}), {});
    }));
  ObjectLibrary(folder_.path()).remove("here");
  auto refreshed = std::async(std::launch::async, [&] { matcher.refresh(false); });
  EXPECT_EQ(refreshed.wait_for(std::chrono::seconds(60)), std::future_status::ready);
  ends = true;
  for (auto& search : searches) search.get();
  refreshed.get();
  EXPECT_TRUE(matcher.find(plate_image({160, 120}), {}).result.searched.empty());
}

TEST_F(LiveMatcherTest, FindsNothingWhileTheLibraryCannotBeRead) {
  store(plate("here", {160, 120}));
  LiveMatcher matcher({}, folder_.path());
  ASSERT_EQ(matcher.find(image_, {}).result.searched.size(), 1u);
  const std::string away = folder_.path() + ".away";
  std::filesystem::rename(folder_.path(), away);
  EXPECT_THROW(matcher.refresh(false), FileError);
  EXPECT_EQ(matcher.fault().rfind("the library cannot be read: ", 0), 0u) << matcher.fault();
  VideoSearch video(VideoConfig{});
  for (const Found& found : {matcher.find(image_, {}), matcher.watch(video, 1, image_, {})}) {
    EXPECT_TRUE(found.result.searched.empty());
    ASSERT_EQ(found.result.skipped.size(), 1u);
    EXPECT_EQ(found.result.skipped.front(), "here: " + matcher.fault());
  }
  std::filesystem::rename(away, folder_.path());
  matcher.refresh(false);
  EXPECT_EQ(matcher.fault(), "");
  EXPECT_EQ(matcher.find(image_, {}).result.searched.size(), 1u);
}

}  // namespace
}  // namespace mbncc::nodelets
