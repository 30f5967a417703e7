// SPDX-License-Identifier: BSD-3-Clause
// Searches that throw or never end, and images that cannot be searched: subscribers are informed
// every time. The test reports the longest delay.
#include <gtest/gtest.h>
#include <mbncc_vision/DetectedObjectArray.h>
#include <ros/ros.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "nodelets/conversion/images.hpp"
#include "nodelets/matching/search_worker.hpp"
#include "nodelets/spin_until.hpp"
#include "support/temporary_folder.hpp"

namespace mbncc::nodelets {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using mbncc_vision::DetectedObject;
using mbncc_vision::DetectedObjectArray;

constexpr int kRounds = 100;

/// Finds one confirmed object in every image, or fails as configured.
class InjectedSearch : public ImageSearch {
 public:
  explicit InjectedSearch(const LiveMatcher& matcher) : matcher_(matcher) {}

  Detections process(const ReceivedImage& received, const SearchRequest&) override {
    if (const auto instead = injected()) instead();
    Detections detections{{}, matcher_.library()};
    detections.array.header = received.header;
    DetectedObject object;
    object.name = "part";
    object.state = DetectedObject::CONFIRMED;
    object.valid_until = received.header.stamp + ros::Duration(100);
    object.pose_valid = true;
    object.pose.pose.orientation.w = 1;
    object.child_frame_id = "object_part_0";
    detections.array.objects.push_back(object);
    return detections;
  }

  void configure(const MatchingNodeConfig&) override {}
  void interrupt() override {}
  void reset() override { ++resets_; }

  void inject(const std::function<void()>& instead) {
    const std::lock_guard<std::mutex> lock(mutex_);
    instead_ = instead;
  }

  int resets() const { return resets_; }

 private:
  std::function<void()> injected() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return instead_;
  }

  const LiveMatcher& matcher_;
  mutable std::mutex mutex_;
  std::function<void()> instead_;
  std::atomic<int> resets_{0};
};

/// Throws every kind of exception that a search may end with.
const std::vector<std::function<void()>>& exceptions() {
  static const std::vector<std::function<void()>> all{
      [] { throw std::runtime_error("injected"); }, [] { throw std::bad_alloc(); },
      [] { CV_Error(cv::Error::StsBadArg, "injected"); },
      [] { throw tf2::LookupException("injected"); }, [] { std::map<int, int>().at(1); }};
  return all;
}

class FailingSearch : public testing::Test {
 protected:
  FailingSearch() {
    detections_ = node_.subscribe<DetectedObjectArray>(
        "detected_objects", 100, [this](const DetectedObjectArray::ConstPtr& array) {
          arrays_.push_back(array);
          heard_ = ros::Time::now();
        });
    transforms_ = node_.subscribe<tf2_msgs::TFMessage>(
        "/tf", 1000, [this](const tf2_msgs::TFMessage::ConstPtr& message) {
          for (const auto& transform : message->transforms) placed_.insert(transform.header.stamp);
        });
    silence_timer_ = node_.createWallTimer(ros::WallDuration(0.1),
                                           [this](const auto&) { worker_.check_stale(true); });
  }

  void SetUp() override {
    ASSERT_TRUE(spin_until([this] { return detections_.getNumPublishers() > 0; }));
  }

  static MatchingNodeConfig config() {
    MatchingNodeConfig config;
    config.max_age = 100;  // a busy machine may search late
    return config;
  }

  /// Publishes an image and returns its stamp.
  ros::Time show(const std::string& encoding = "") {
    std_msgs::Header header;
    header.stamp = std::max(ros::Time::now(), last_stamp_ + ros::Duration(0, 1));
    header.frame_id = "camera";
    last_stamp_ = header.stamp;
    auto image = encode_image(cv::Mat(24, 32, CV_8UC3, cv::Scalar::all(90)), header);
    if (!encoding.empty()) image.encoding = encoding;
    worker_.put(boost::make_shared<sensor_msgs::Image>(image));
    return header.stamp;
  }

  /// Waits for the message about the image with this stamp.
  DetectedObjectArray::ConstPtr about(const ros::Time& stamp) {
    DetectedObjectArray::ConstPtr found;
    EXPECT_TRUE(spin_until([&] {
      for (const auto& array : arrays_)
        if (array->header.stamp == stamp) found = array;
      return found != nullptr;
    }));
    return found ? found : boost::make_shared<DetectedObjectArray>();
  }

  bool is_stale() const {
    return !arrays_.empty() && arrays_.back()->status == DetectedObjectArray::STALE;
  }

  int level() const {
    diagnostic_updater::DiagnosticStatusWrapper status;
    summarize(status, "", "", worker_.statistics());
    return status.level;
  }

  const test::TemporaryFolder folder_;
  ros::NodeHandle node_;
  LiveSettings settings_{config()};
  const LiveMatcher matcher_{{}, folder_.path()};
  InjectedSearch search_{matcher_};
  CameraInput camera_{node_, {"raw", 60}, [](const auto&) {}};
  DetectionPublisher publisher_{node_, ros::NodeHandle("~"), [] {}};
  SearchWorker worker_{SearchTools{settings_, matcher_, search_, camera_, publisher_}};
  ros::Subscriber detections_, transforms_;
  ros::WallTimer silence_timer_;
  std::vector<DetectedObjectArray::ConstPtr> arrays_;
  std::set<ros::Time> placed_;  // stamps of transforms
  ros::Time last_stamp_, heard_;
};

TEST_F(FailingSearch, AlwaysEndsInAStatus) {
  ros::Time good;
  double longest = 0;
  for (int round = 0; round < kRounds; ++round) {
    search_.inject({});
    good = show();
    ASSERT_EQ(about(good)->objects.size(), 1u) << round;
    EXPECT_TRUE(spin_until([this] { return level() == DiagnosticStatus::OK; }));
    search_.inject(exceptions()[static_cast<std::size_t>(round) % exceptions().size()]);
    const int resets = search_.resets();
    const ros::Time failed = show();
    const auto array = about(failed);
    longest = std::max(longest, (heard_ - failed).toSec());
    ASSERT_EQ(array->status, DetectedObjectArray::SEARCH_FAILED) << round;
    EXPECT_EQ(array->message.rfind("the search failed: ", 0), 0u) << array->message;
    EXPECT_TRUE(array->objects.empty());
    EXPECT_EQ(array->header.frame_id, "camera");
    EXPECT_TRUE(spin_until([this] { return level() == DiagnosticStatus::ERROR; }));
    EXPECT_EQ(worker_.statistics().failed, static_cast<std::uint64_t>(round + 1));
    EXPECT_GT(search_.resets(), resets) << "half an image is forgotten";
    EXPECT_EQ(placed_.count(failed), 0u) << "no tf of an image that was not searched";
    if (HasFailure()) return;
  }
  RecordProperty("longest_until_told_ms", static_cast<int>(1000 * longest));
  EXPECT_TRUE(spin_until([&] { return placed_.count(good) > 0; })) << "tf of the others is heard";
}

TEST_F(FailingSearch, ASearchThatNeverEndsIsStale) {
  std::promise<void> end;
  ASSERT_EQ(about(show())->objects.size(), 1u);
  search_.inject([ended = end.get_future().share()] { ended.wait(); });
  show();
  EXPECT_TRUE(spin_until([this] { return is_stale(); }));
  EXPECT_EQ(level(), DiagnosticStatus::ERROR);
  end.set_value();
}

// Images that the rate limit skips must not hide failed searches.
TEST_F(FailingSearch, RefusedImagesAreStaleAtALowRate) {
  settings_.change([](MatchingNodeConfig& config) { config.max_rate = 0.5; });
  ASSERT_EQ(about(show())->objects.size(), 1u);
  const ros::WallTimer playing =
      node_.createWallTimer(ros::WallDuration(0.05), [this](const auto&) { show("nonsense"); });
  EXPECT_TRUE(spin_until([this] { return is_stale(); }));
  EXPECT_EQ(level(), DiagnosticStatus::ERROR);
}

}  // namespace
}  // namespace mbncc::nodelets

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "failing_search_rostest");
  const ros::NodeHandle keeps_the_node_running;
  return RUN_ALL_TESTS();
}
