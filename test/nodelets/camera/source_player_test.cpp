// SPDX-License-Identifier: BSD-3-Clause
#include "nodelets/camera/source_player.hpp"

#include <diagnostic_updater/DiagnosticStatusWrapper.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "mbncc/error.hpp"

namespace mbncc::nodelets {
namespace {

using Seconds = SourcePlayer::Seconds;

/// A scripted camera in a simulated environment, whose clocks advance only during pauses.
struct Story {
  bool live = false;
  double rate = 0;    // [Hz]
  int openings = 0;   // attempts to open it so far
  int refusals = 0;   // failed attempts before one succeeds
  int images = 1000;  // number of images until the end
  int grabbed = 0, retrieved = 0;
  int fails_at = -1, unreadable = -1;  // numbers of grabs
  bool same_image = false;
};

class ToldSource : public ImageSource {
 public:
  explicit ToldSource(Story& story) : story_(story) {}

  bool grab() override {
    if (story_.grabbed == story_.fails_at) {
      ++story_.grabbed;
      throw FileError("camera", "it was unplugged");
    }
    return story_.grabbed < story_.images && ++story_.grabbed > 0;
  }

  cv::Mat retrieve() override {
    ++story_.retrieved;
    if (story_.grabbed - 1 == story_.unreadable) throw FileError("camera", "rubbish");
    return cv::Mat(4, 4, CV_8UC1, cv::Scalar(story_.same_image ? 7 : story_.grabbed));
  }

  bool is_live() const override { return story_.live; }
  double rate() const override { return story_.rate; }

 private:
  Story& story_;
};

class SourcePlayerTest : public testing::Test {
 protected:
  void SetUp() override { config_.source = "camera"; }

  SourcePlayer::Callbacks callbacks() {
    SourcePlayer::Callbacks callbacks;
    callbacks.open = [this]() -> std::unique_ptr<ImageSource> {
      if (++story_.openings <= story_.refusals) throw FileError("camera", "no such device");
      return std::make_unique<ToldSource>(story_);
    };
    callbacks.has_listener = [this] { return listens_; };
    callbacks.time = [this] { return clock_runs_ ? time_ += ros::Duration(0.001) : time_; };
    callbacks.steady_time = [this] { return steady_; };
    callbacks.pause = [this](Seconds pause) {
      pauses_.push_back(pause.count());
      steady_ += std::chrono::duration_cast<SourcePlayer::Clock::duration>(pause);
    };
    callbacks.publish = [this](const cv::Mat& image, const ros::Time& stamp) {
      published_.push_back(image.at<uchar>(0, 0));
      stamps_.push_back(stamp);
    };
    return callbacks;
  }

  SourcePlayer& player() {
    if (!player_) player_ = std::make_unique<SourcePlayer>(config_, callbacks());
    return *player_;
  }

  void play(int steps) {
    for (int i = 0; i < steps; ++i) player().step();
  }

  std::string state() {
    diagnostic_updater::DiagnosticStatusWrapper status;
    player().health().describe(status);
    return status.message;
  }

  std::string count(const std::string& key) {
    diagnostic_updater::DiagnosticStatusWrapper status;
    player().health().describe(status);
    for (const auto& value : status.values)
      if (value.key == key) return value.value;
    return "no such count";
  }

  CameraConfig config_;
  Story story_;
  bool listens_ = true, clock_runs_ = true;
  ros::Time time_{100, 0};
  SourcePlayer::Clock::time_point steady_;
  std::vector<double> pauses_;
  std::vector<int> published_;
  std::vector<ros::Time> stamps_;
  std::unique_ptr<SourcePlayer> player_;
};

TEST_F(SourcePlayerTest, PublishesImageAfterImageWithGrowingStamps) {
  play(5);
  EXPECT_EQ(published_, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(std::is_sorted(stamps_.begin(), stamps_.end()));
  EXPECT_EQ(count("published"), "5");
  EXPECT_EQ(state(), "open");
}

TEST_F(SourcePlayerTest, RetriesAfterPausesThatDoubleUpToEightSeconds) {
  story_.refusals = 7;
  play(7);
  EXPECT_EQ(pauses_, (std::vector<double>{0.5, 1, 2, 4, 8, 8, 8}));
  EXPECT_NE(state().find("no such device"), std::string::npos);
  EXPECT_EQ(count("failures of the source"), "7");
  play(1);
  EXPECT_EQ(published_.size(), 1u);
}

TEST_F(SourcePlayerTest, AnImageResetsTheRetryPause) {
  story_.live = true;
  story_.refusals = 3;
  story_.fails_at = 2;
  play(6);
  EXPECT_EQ(pauses_, (std::vector<double>{0.5, 1, 2, 0.5}));
  EXPECT_NE(state().find("unplugged"), std::string::npos);
  play(1);
  EXPECT_EQ(story_.openings, 5);
  EXPECT_EQ(state(), "open");
}

TEST_F(SourcePlayerTest, AFolderWaitsForAListener) {
  listens_ = false;
  play(3);
  EXPECT_EQ(story_.grabbed, 0);
  listens_ = true;
  play(1);
  EXPECT_EQ(published_, std::vector<int>{1});
}

TEST_F(SourcePlayerTest, AFolderWaitsForTheClockAndForANewStamp) {
  clock_runs_ = false;
  time_ = ros::Time();
  play(3);
  EXPECT_EQ(story_.grabbed, 0) << "the clock has not begun";
  time_ = ros::Time(5);
  play(3);
  EXPECT_EQ(published_, std::vector<int>{1}) << "the clock stands still";
  time_ = ros::Time(6);
  play(1);
  EXPECT_EQ(published_, (std::vector<int>{1, 2}));
}

TEST_F(SourcePlayerTest, ALiveSourceIsEmptiedButNotDecodedWithoutListeners) {
  story_.live = true;
  listens_ = false;
  play(4);
  EXPECT_EQ(story_.grabbed, 4);
  EXPECT_EQ(story_.retrieved, 0);
}

TEST_F(SourcePlayerTest, ALiveSourceGetsNoStampTwice) {
  story_.live = true;
  clock_runs_ = false;
  play(3);
  EXPECT_EQ(published_, std::vector<int>{1});
  EXPECT_EQ(count("images without a new stamp"), "2");
}

TEST_F(SourcePlayerTest, KeepsTheFrameRateWithoutCatchingUp) {
  config_.frame_rate = 4;
  play(4);
  EXPECT_EQ(pauses_, (std::vector<double>{0.25, 0.25, 0.25}));
  steady_ += std::chrono::seconds(10);
  play(2);
  EXPECT_EQ(pauses_, (std::vector<double>{0.25, 0.25, 0.25, 0.25}));
}

TEST_F(SourcePlayerTest, UsesTheSourcesRateOrTenHertz) {
  story_.rate = 2;
  play(2);
  EXPECT_EQ(pauses_, std::vector<double>{0.5});
  story_.rate = 0;
  play(2);
  EXPECT_EQ(pauses_, (std::vector<double>{0.5, 0.5, 0.1}));
}

TEST_F(SourcePlayerTest, UnreadableImagesAreCountedAndSkipped) {
  story_.unreadable = 1;
  play(3);
  EXPECT_EQ(published_, (std::vector<int>{1, 3}));
  EXPECT_EQ(count("unreadable images"), "1");
}

TEST_F(SourcePlayerTest, TheEndIsReportedAndLasts) {
  story_.images = 2;
  play(5);
  EXPECT_EQ(published_.size(), 2u);
  EXPECT_EQ(state(), "finished; loop (cell.launch loop:=true) plays it again and again");
  EXPECT_EQ(story_.openings, 1);
}

TEST_F(SourcePlayerTest, RecordingsMayRepeatAnImage) {
  story_.same_image = true;
  play(8);
  EXPECT_EQ(published_.size(), 8u);
  EXPECT_EQ(state(), "open");
}

TEST_F(SourcePlayerTest, AFrozenImageOfALiveSourceIsNotPublishedAndTheSourceIsOpenedAgain) {
  story_.live = story_.same_image = true;
  play(5);
  EXPECT_EQ(published_.size(), 4u);
  EXPECT_EQ(count("frozen images"), "1");
  EXPECT_NE(state().find("frozen"), std::string::npos);
  play(2);
  EXPECT_EQ(published_.size(), 4u) << "it repeats the image after it was opened again";
  EXPECT_EQ(story_.openings, 3);
  EXPECT_EQ(pauses_, std::vector<double>(3, 0.5));
  story_.same_image = false;
  play(1);
  EXPECT_EQ(published_.size(), 5u);
  EXPECT_EQ(state(), "open");
}

TEST_F(SourcePlayerTest, ALiveSourceMayRepeatAnImageIfItIsTold) {
  config_.detect_frozen = false;
  story_.live = story_.same_image = true;
  play(8);
  EXPECT_EQ(published_.size(), 8u);
}

}  // namespace
}  // namespace mbncc::nodelets
