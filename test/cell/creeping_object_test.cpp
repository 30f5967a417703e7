// SPDX-License-Identifier: BSD-3-Clause
// Objects that move too slowly for the change map: VideoSearch searches for them again in time, and
// not more often than that.
#include <gtest/gtest.h>

#include <functional>
#include <opencv2/imgproc.hpp>

#include "cell/incremental_search/frame_search.hpp"
#include "cell/watched_scene.hpp"
#include "mbncc/cell/pose_average.hpp"
#include "mbncc/cell/tracker.hpp"

namespace mbncc {
namespace {

constexpr double kMostBehind = 1.5;  // [px]
constexpr double kSlowFrames = 0.1;  // [s]
const cv::Size kSmall(200, 150);     // [px]
const Pose2D kTaughtAt{100, 75, 0}, kStart{60.3, 60.2, 0.3};

/// A plain plate on a plain platform, in noise.
class Plate {
 public:
  /// Half its width is `half` px, or less at one corner.
  Plate(double contrast, double noise, double half = 18)
      : contrast_(contrast), noise_(noise), half_(half) {}

  std::shared_ptr<const ObjectModel> learned() {
    auto model = std::make_shared<ObjectModel>();
    model->name = "plate";
    model->views = {crop_view(show({kTaughtAt}), coverage(kTaughtAt) > 127, kTaughtAt)};
    return model;
  }

  /// An image of plates at these poses; `light` (CV_32FC3) may be empty.
  cv::Mat show(const std::vector<Pose2D>& poses, const cv::Mat& light = {}) {
    cv::Mat image(kSmall, CV_32FC3), drawn;
    random_.fill(image, cv::RNG::NORMAL, 0, noise_);
    cv::Mat brightness(kSmall, CV_32FC1, cv::Scalar(120));
    for (const auto& pose : poses)
      cv::scaleAdd(as_float(coverage(pose)), contrast_ / 255, brightness, brightness);
    cv::merge(std::vector<cv::Mat>(3, brightness), drawn);
    image += light.empty() ? drawn : drawn.mul(light);
    image.convertTo(image, CV_8U);
    return image;
  }

 private:
  static cv::Mat as_float(const cv::Mat& image) {
    cv::Mat converted;
    image.convertTo(converted, CV_32F);
    return converted;
  }

  /// Covered part of each pixel, of 255.
  cv::Mat coverage(const Pose2D& pose) const {
    constexpr int kFine = 8;
    std::vector<cv::Point> corners;
    for (const auto& corner :
         {cv::Point2d(-35, -half_), {35, -half_}, {35, half_ / 4}, {10, half_}, {-35, half_}}) {
      const cv::Point2d at = rotate(corner, pose.theta) + pose.position() + cv::Point2d(.5, .5);
      corners.emplace_back(cvRound(at.x * kFine), cvRound(at.y * kFine));
    }
    cv::Mat fine = cv::Mat::zeros(kSmall * kFine, CV_8UC1), covered;
    cv::fillPoly(fine, std::vector<std::vector<cv::Point>>{corners}, 255);
    cv::resize(fine, covered, kSmall, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(covered, covered, {}, 0.6);
    return covered;
  }

  double contrast_, noise_;  // [grey levels]
  double half_;              // [px]
  cv::RNG random_{7};
};

struct Creep {
  double contrast, noise, speed;  // [grey levels], [grey levels], [px per image]
};

class CreepingObject : public ::testing::TestWithParam<Creep> {};

// Up to 5.8 px (first row) without further searches of instances at rest.
TEST_P(CreepingObject, IsConfirmedOnlyNearItsPlace) {
  const Creep creep = GetParam();
  Plate plate(creep.contrast, creep.noise);
  Matcher matcher;
  matcher.set_objects({plate.learned()});
  VideoSearch video;
  InstanceTracker tracker;
  PoseAverage average(10);
  Pose2D pose = kStart;
  int confirmed = 0;
  const int count = 15 + std::min(160, static_cast<int>(12 / creep.speed));
  for (int i = 0; i < count; ++i) {
    if (i >= 15) pose.x += creep.speed;
    const double stamp = kSlowFrames * i;
    auto tracked = tracker.update(stamp, video.find(matcher, stamp, plate.show({pose})).matches);
    average.apply(tracked);
    for (const auto& one : tracked) {
      if (one.state != TrackState::kConfirmed) continue;
      ++confirmed;
      EXPECT_LE(cv::norm(one.match.pose.position() - pose.position()), kMostBehind) << i;
    }
  }
  EXPECT_GE(confirmed, count / 3);
}

INSTANTIATE_TEST_SUITE_P(Speeds, CreepingObject,
                         testing::Values(Creep{9, 2, 0.015}, Creep{9, 2, 0.05}, Creep{9, 2, 0.1},
                                         Creep{9, 2, 0.3}, Creep{20, 10, 0.015},
                                         Creep{20, 10, 0.05}, Creep{20, 10, 0.1},
                                         Creep{20, 10, 0.3}));

TEST(RestingInstance, ThatIsNotFoundAgainIsSearchedForEverywhere) {
  Plate plate(40, 2);
  Matcher matcher;
  matcher.set_objects({plate.learned()});
  const VideoConfig config;
  incremental_search::SearchMemory memory({}, matcher.config());
  auto& instances = memory.instances.all();
  for (int i = 0; i < 30; ++i) {
    if (i == 20) {  // as if it had come from there without a change
      instances.at(0).match.pose.x += 60;
      for (auto& point : instances[0].match.outline) point.x += 60;
    }
    const cv::Mat image = plate.show({kStart});
    incremental_search::FrameSearch search(memory, config, matcher, kSlowFrames * i, image);
    i == 0 ? search.search_whole_image() : search.search_changes();
  }
  ASSERT_EQ(instances.size(), 1u);
  EXPECT_LT(cv::norm(instances[0].match.pose.position() - kStart.position()), 1);
}

TEST(CloseNeighbours, StayGraspable) {
  Plate plate(60, 2, 5);
  Matcher matcher;
  matcher.set_objects({plate.learned()});
  VideoSearch video;
  for (int i = 0; i < 50; ++i) {
    const auto result =
        video.find(matcher, kSlowFrames * i, plate.show({{90, 60, 0}, {106, 76, 0}}));
    ASSERT_EQ(result.matches.size(), 2u) << i;
    for (const auto& match : result.matches) EXPECT_TRUE(match.graspable) << i;
  }
}

/// Numbers of searches for an instance at rest.
class RestingObject : public ::testing::Test {
 protected:
  /// Images of `count` after the first `skip` in which the instance was searched for.
  int searches(int skip, int count, const std::function<cv::Mat(int)>& image) {
    matcher_.set_objects({plate_.learned()});
    int fresh = 0;
    for (int i = 0; i < skip + count; ++i) {
      const auto result = video_.find(matcher_, kSlowFrames * i, image(i));
      for (const auto& match : result.matches) fresh += i >= skip && match.fresh;
    }
    return fresh;
  }

  Plate plate_{40, 2};
  Matcher matcher_;
  VideoSearch video_;
};

TEST_F(RestingObject, IsSearchedForEveryHalfSecond) {
  const int fresh = searches(20, 50, [&](int) { return plate_.show({kStart}); });
  EXPECT_GE(fresh, 9);
  EXPECT_LE(fresh, 11);
}

TEST_F(RestingObject, ADriftOfTheLightCostsNoFurtherSearches) {
  cv::Mat ramp(kSmall, CV_32FC3);
  for (int x = 0; x < kSmall.width; ++x)
    ramp.col(x).setTo(cv::Scalar::all((x - kSmall.width / 2) / (kSmall.width / 2.0)));
  const int fresh = searches(20, 100, [&](int i) {
    return plate_.show({kStart}, cv::Scalar::all(1) + 0.0002 * i * ramp);
  });
  EXPECT_LE(fresh, 21);
}

// Three instances found in one image are searched for in different ones, but none waits for long.
TEST_F(RestingObject, NeitherWaitsForTheOthersNorIsSearchedWithThem) {
  const std::vector<Pose2D> three{{60, 30, 0}, {60, 75, 0}, {60, 120, 0}};
  std::vector<double> last(3, 0);
  matcher_.set_objects({plate_.learned()});
  int most = 0;
  for (int i = 0; i < 80; ++i) {
    // Two images a second: fewer than searches are due.
    const double stamp = i < 40 ? kSlowFrames * i : 4 + 0.5 * (i - 40);
    const auto result = video_.find(matcher_, stamp, plate_.show(three));
    ASSERT_EQ(result.matches.size(), 3u) << i;
    int fresh = 0;
    for (const auto& match : result.matches) {
      double& searched = last[static_cast<std::size_t>(match.pose.y / 50)];
      if (match.fresh) searched = stamp;
      fresh += match.fresh;
      EXPECT_LE(stamp - searched, i < 44 ? 4 : 0.51) << i;
    }
    if (i >= 35 && i < 40) most = std::max(most, fresh);
  }
  EXPECT_EQ(most, 1);
}

}  // namespace
}  // namespace mbncc
