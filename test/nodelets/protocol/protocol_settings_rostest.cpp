// SPDX-License-Identifier: BSD-3-Clause
// Settings at run time of the matching nodelet, and their effects.
#include <dynamic_reconfigure/Reconfigure.h>
#include <mbncc_vision/FindObjects.h>
#include <sensor_msgs/RegionOfInterest.h>

#include "mbncc/library/object_library.hpp"
#include "nodelets/protocol/protocol.hpp"

namespace mbncc::nodelets {
namespace {

using dynamic_reconfigure::Config;

class RunTimeSettings : public Protocol {
 protected:
  void SetUp() override {
    Protocol::SetUp();
    ASSERT_EQ(teacher_.teach(given("part")).error_code, Result::SUCCESS);
    playing_ = play();
    ASSERT_TRUE(spin_until([this] { return sees(DetectedObject::CONFIRMED); }));
  }

  void TearDown() override { EXPECT_TRUE(edit("part", EditObject::Request::DELETE).success); }

  bool sees(std::uint8_t state) const {
    return array_ && array_->objects.size() == 1 && array_->objects[0].state == state;
  }

  /// Waits until the predicate holds for an image that is published after this call.
  template <class Predicate>
  bool comes_to(const Predicate& predicate) {
    const int before = arrays_;
    return spin_until([&] { return arrays_ > before && predicate(); });
  }

  Config set(const Config& config) {
    dynamic_reconfigure::Reconfigure::Request request;
    request.config = config;
    return call<dynamic_reconfigure::Reconfigure>("matching/set_parameters", request).config;
  }

  Config set(const std::string& name, double value) {
    Config config;
    config.doubles.resize(1);
    config.doubles[0].name = name;
    config.doubles[0].value = value;
    return set(config);
  }

  Config set_int(const std::string& name, int value) {
    Config config;
    config.ints.resize(1);
    config.ints[0].name = name;
    config.ints[0].value = value;
    return set(config);
  }

  Config set_roi(const std::string& roi) {
    Config config;
    config.strs.resize(1);
    config.strs[0].name = "search_roi";
    config.strs[0].value = roi;
    return set(config);
  }

  ros::WallTimer playing_;
};

TEST_F(RunTimeSettings, ThresholdsAndMarginsControlConfirmation) {
  const std::map<std::string, double> strict{
      {"confirm_score", 1}, {"min_margin_place", 100}, {"min_margin_angle", 100}};
  const std::map<std::string, double> usual{
      {"confirm_score", 0.7}, {"min_margin_place", 6}, {"min_margin_angle", 6}};
  for (const auto& [name, value] : strict) {
    set(name, value);
    EXPECT_TRUE(comes_to([this] {
      return array_->objects.size() == 1 && !sees(DetectedObject::CONFIRMED);
    })) << name;
    EXPECT_FALSE(array_->objects.at(0).reasons.empty()) << name;
    set(name, usual.at(name));
    EXPECT_TRUE(comes_to([this] { return sees(DetectedObject::CONFIRMED); })) << name;
  }
}

TEST_F(RunTimeSettings, ConfirmingMayTakeLongerButNotLongerThanItsWindow) {
  const Config refused = set_int("confirm_frames", 9);
  for (const auto& number : refused.ints) {
    if (number.name == "confirm_frames") {
      EXPECT_EQ(number.value, 3) << "of a window of 5";
    }
  }
  Config both;
  both.ints.resize(2);
  both.ints[0].name = "confirm_frames";
  both.ints[1].name = "confirm_window";
  both.ints[0].value = both.ints[1].value = 100;
  set(both);
  EXPECT_TRUE(comes_to([this] { return sees(DetectedObject::NEW); }));
  both.ints[0].value = 3;
  both.ints[1].value = 5;
  set(both);
  EXPECT_TRUE(comes_to([this] { return sees(DetectedObject::CONFIRMED); }));
}

TEST_F(RunTimeSettings, LostInstancesCanBeHeld) {
  set("hold_time", 60);
  set_roi("0,0,20,20");  // the object does not lie in this region
  EXPECT_TRUE(comes_to([this] {
    return !array_->objects.empty() && array_->objects[0].state == DetectedObject::HELD;
  }));
  set("hold_time", 0);
  EXPECT_TRUE(comes_to([this] { return array_->objects.empty(); }));
  set_roi("");
  EXPECT_TRUE(comes_to([this] { return sees(DetectedObject::CONFIRMED); }));
}

TEST_F(RunTimeSettings, TheRegionCanBeSetByTopic) {
  auto publisher = node_.advertise<sensor_msgs::RegionOfInterest>("matching/search_roi", 1);
  ASSERT_TRUE(spin_until([&] { return publisher.getNumSubscribers() == 1; }));
  sensor_msgs::RegionOfInterest roi;
  roi.width = roi.height = 20;
  publisher.publish(roi);
  EXPECT_TRUE(comes_to([this] { return array_->objects.empty(); }));
  // The parameter server is updated slightly later than the search.
  EXPECT_TRUE(spin_until([] {
    std::string stored;
    return ros::param::get("matching/search_roi", stored) && stored == "0,0,20,20";
  }));
  publisher.publish(sensor_msgs::RegionOfInterest());  // the whole image
  EXPECT_TRUE(comes_to([this] { return sees(DetectedObject::CONFIRMED); }));
}

TEST_F(RunTimeSettings, AnInvalidRegionIsRefused) {
  for (const auto& text : set_roi("10,20").strs) {
    if (text.name == "search_roi") {
      EXPECT_EQ(text.value, "");
    }
  }
}

TEST_F(RunTimeSettings, AnObjectsOwnThresholdIsSetByService) {
  EditObject::Request request;
  request.name = "part";
  request.command = request.SET_THRESHOLD;
  request.min_score = 1;
  ASSERT_TRUE(call<EditObject>("edit_object", request).success);
  EXPECT_TRUE(comes_to([this] { return array_->objects.empty(); }));
  request.clear = true;
  ASSERT_TRUE(call<EditObject>("edit_object", request).success);
  EXPECT_TRUE(comes_to([this] { return sees(DetectedObject::CONFIRMED); }));
}

TEST_F(RunTimeSettings, TheMatchingNodeletReportsWhatItSearchesFor) {
  ASSERT_TRUE(spin_until([this] {
    const auto known = call<mbncc_vision::ListObjects>("matching/list_objects", {});
    return known.objects.size() == 1 && known.objects[0].name == "part";
  }));
}

TEST_F(RunTimeSettings, BothNodeletsTellWhichFolderTheLibraryIs) {
  for (const auto* service : {"list_objects", "matching/list_objects"}) {
    const auto known = call<mbncc_vision::ListObjects>(service, {});
    EXPECT_NE(known.library_inode, 0u);
    EXPECT_EQ(known.library_inode, folder_inode(known.library_path)) << service;
  }
}

TEST_F(RunTimeSettings, ApplyToFindObjects) {
  set("min_score", 1);
  mbncc_vision::FindObjects::Request request;
  request.image = before_;
  EXPECT_TRUE(call<mbncc_vision::FindObjects>("find_objects", request).detections.objects.empty());
  set("min_score", 0.5);
  EXPECT_EQ(call<mbncc_vision::FindObjects>("find_objects", request).detections.objects.size(), 1u);
}

}  // namespace
}  // namespace mbncc::nodelets
